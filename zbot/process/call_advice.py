"""Advice for a call or an operator that Python refuses: `node.get_logger().info("speed", 5)`.

Python says what is wrong, but not what to write.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.errors.suggestion import nearest

if TYPE_CHECKING:
    from types import TracebackType

_MISSING = re.compile(
    r"\A(?:((?:\w+Broadcaster|\w+Listener)\.|(?:Client|LifecycleNode|Logger|Node|Publisher)\w*\.)\w*|"
    r"spin\w*)\(\) "
    r"missing \d+ required positional arguments?: .*'(\w+)'\Z"
)
#: What to write for an argument that a program forgot.
_ARGUMENTS = {
    "request": "the request, e.g. Trigger.Request()",
    "timer_period_sec": "the seconds between two calls, e.g. 0.5",
    "node_name": "the node's name, e.g. super().__init__('my_node')",
    "qos_profile": "the depth of the queue, e.g. 10",
    "node": "the node, e.g. rclpy.spin(node)",
    "future": "the node and the future: spin_until_future_complete(node, future)",
    "message": "the text, e.g. info('ready')",
    "msg": "the message, e.g. publish(message)",
    "callback": "the function to call, e.g. self.callback",
}
#: What to write for other texts of a TypeError. `{}` is the first group of the text.
_SENTENCES = {
    r"(?:Lifecycle)?Node\.create_\w+\(\) got .* argument 'queue_size'": "qos_profile=10",
    r"(?:Lifecycle)?Node\.create_\w+\(\) got .* argument '(?:qos|depth)'": "qos_profile=10",
    r"(?:Lifecycle)?Node\.create_\w+\(\) got .* argument 'topic_name'": "topic='chatter'",
    r"(?:Lifecycle)?Node\.create_timer\(\) got .* argument '\w*(?:period|interval)\w*'": (
        "timer_period_sec=0.5"
    ),
    r"(?:Lifecycle)?Node\.__init__\(\) got .* argument 'name'": "node_name='my_node'",
    r"Logger\.(\w+)\(\) takes 2 positional": "one text, e.g. {}(f'speed: {{self.speed}}')",
    r"Client\.(call\w*)\(\) takes .* positional": (
        "one request, e.g. {}(AddTwoInts.Request(a=1, b=2))"
    ),
    r"(\w*TransformBroadcaster)\.sendTransform\(\) takes": (
        "sendTransform(transform), with one TransformStamped"
    ),
    r"create_node\(\) missing": "the node's name, e.g. create_node('my_node')",
    r"spin_once\(\) takes 1 positional": "spin_once(node, timeout_sec=1.0)",
    r"Duration\.__init__\(\) takes 1 positional": "Duration(seconds=1.5)",
    r"Time\.__init__\(\) takes 1 positional": "Time(seconds=1.5)",
    r"unsupported operand type\(s\) for [-+]=?: 'Time' and '(?:int|float)'": (
        "Duration(seconds=5.0) in place of a number"
    ),
    r"unsupported operand type\(s\) for -: 'Time' and 'Time'": (
        "Time.from_msg(message.header.stamp) for the time of a message"
    ),
    r"'[<>]=?' not supported between instances of 'Duration' and '(?:int|float)'": (
        "duration.nanoseconds / 1e9 for the seconds of a duration"
    ),
    r"'[<>]=?' not supported between instances of 'Time' and '(?:int|float)'": (
        "time.nanoseconds / 1e9 for the seconds of a time"
    ),
    r"module\(\) takes at most 2 arguments": "the class in the module, e.g. rclpy.node.Node",
    r"descriptor '__init__' requires a 'super' object": (
        "super().__init__(...), with parentheses after super"
    ),
    # `/` and others with a parameter in place of its value
    r"(?!'Parameter' object).*'Parameter'(?! object)": "get_parameter('name').value",
}


def advise_of_call(error: BaseException) -> None:
    """Add to a TypeError about a call or an operator what to write, if this is known."""
    if type(error) is not TypeError:
        return
    advice = _of_missing_argument(error) or _of_text(str(error))
    if advice:
        error.args = (f"{error}: {advice}",)


def _of_missing_argument(error: TypeError) -> str:
    missing = _MISSING.search(str(error))
    if missing is None or missing[2] not in _ARGUMENTS:
        return ""
    if missing[1] and missing[2] == "node":
        return f"write the node, e.g. {missing[1]}(self)".replace(".(", "(")
    return _misspelt_init(error.__traceback__) or f"write {_ARGUMENTS[missing[2]]}"


def _of_text(text: str) -> str:
    for pattern, sentence in _SENTENCES.items():
        if match := re.match(pattern, text):
            return "write " + sentence.format(*match.groups())
    return ""


def _misspelt_init(trace: TracebackType | None) -> str:
    """Return what to write if a class of the program has a method such as `_init_` or `__int__`."""
    names = trace.tb_frame.f_globals.values() if trace is not None else ()
    for known in [value for value in names if isinstance(value, type)]:
        methods = [] if "__init__" in vars(known) else vars(known)
        for method in methods:
            word = method.strip("_")
            if method.startswith("_") and (word == "init" or nearest("init", [word])):
                return f"the class {known.__name__} has `{method}`: write `__init__`"
    return ""
