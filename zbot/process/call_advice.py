"""Advice for a call or an operator that Python refuses: `node.get_logger().info("speed", 5)`.

Python says what is wrong, but not what to write.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from zbot.errors import library_name
from zbot.errors.suggestion import nearest

if TYPE_CHECKING:
    from types import TracebackType

_NUMBER = "'(?:int|float)'"
_WITH_NUMBER = f"(?:'(?:Duration|Time)' and {_NUMBER}|{_NUMBER} and '(?:Duration|Time)')"
_UNSUPPORTED = r"unsupported operand type\(s\) for"
_UNORDERED = "'[<>]=?' not supported between instances of"
_MISSING = re.compile(
    r"\A(?:((?:\w+Broadcaster|\w+Listener)\.|(?:Buffer|Client|LifecycleNode|Logger|Node|Publisher)\w*\.)\w*|"
    r"spin\w*)\(\) "
    r"missing \d+ required positional arguments?: .*'(\w+)'\Z"
)
#: What to write for an argument that a program forgot. `{library}` is `rclpy` or `zbot`.
_ARGUMENTS = {
    "request": "the request, e.g. Trigger.Request()",
    "timer_period_sec": "the seconds between two calls, e.g. 0.5",
    "node_name": "the node's name, e.g. super().__init__('my_node')",
    "qos_profile": "the depth of the queue, e.g. 10",
    "node": "the node, e.g. {library}.spin(node)",
    "future": "the node and the future: spin_until_future_complete(node, future)",
    "message": "the text, e.g. info('ready')",
    "msg": "the message, e.g. publish(message)",
    "parameters": "the namespace first, e.g. declare_parameters('', [('speed', 1.0)])",
    "time": "the time, e.g. lookup_transform('map', 'base_link', Time()) for the newest transform",
    "callback": "the function to call, e.g. self.callback",
}
#: What to write for other texts. `{}` is the next group of the text, `{Node}` the class of nodes.
_SENTENCES = {
    r"(?:Lifecycle)?Node\.create_\w+\(\) got .* argument 'queue_size'": "qos_profile=10",
    r"(?:Lifecycle)?Node\.create_\w+\(\) got .* argument '(?:qos|depth)'": "qos_profile=10",
    r"(?:Lifecycle)?Node\.create_\w+\(\) got .* argument 'topic_name'": "topic='chatter'",
    r"(?:Lifecycle)?Node\.create_timer\(\) got .* argument '\w*(?:period|interval)\w*'": (
        "timer_period_sec=0.5"
    ),
    r"(?:Lifecycle)?Node\.__init__\(\) got .* argument 'name'": "node_name='my_node'",
    r"(?:Lifecycle)?Node\.__init__\(\) takes 2 positional": (
        "only the name, e.g. super().__init__('my_node') without self, and other arguments with "
        "their names, e.g. namespace='/arm'"
    ),
    r"(?:Lifecycle)?Node\.(get_\w+)\(\) takes 1 positional": "{}(), without arguments",
    r"object\.__init__\(\) takes exactly one argument": (
        "the base class after the name of the class, e.g. class Robot(Node):"
    ),
    r"Executor\.(add_node|remove_node)\(\) takes 2 positional": "one {}(node) for each node",
    r"(?:\w+Threaded)?Executor\.(\w+)\(\) missing .*'(?:self|(\w+))'": (
        "executor = SingleThreadedExecutor(), with parentheses, and executor.{}({})"
    ),
    r"(?:.+\.)?(\w+)\.(\w+)\(\) missing \d+ required positional arguments?: 'self'": (
        "parentheses after the class, e.g. {}(...).{}()"
    ),
    r"(?:.+\.)?\w+\.(\w+)\(\) takes 0 positional arguments but 1 was given": (
        "self as the first parameter: def {}(self):"
    ),
    r".*\(\) argument after \* must be an iterable": (
        "a comma after a single argument, e.g. args=(node,)"
    ),
    r"Logger\.(\w+)\(\) takes 2 positional": "one text, e.g. {}(f'speed: {{self.speed}}')",
    r"Client\.(call\w*)\(\) takes .* positional": (
        "one request, e.g. {}(AddTwoInts.Request(a=1, b=2))"
    ),
    r"(\w*TransformBroadcaster)\.sendTransform\(\) takes": (
        "sendTransform(transform), with one TransformStamped"
    ),
    r"(?:Approximate)?TimeSynchronizer\.__init__\(\) (?:got|missing|takes)": (
        "the filters in a list: TimeSynchronizer([a, b], 10) for equal stamps, or "
        "ApproximateTimeSynchronizer([a, b], 10, 0.1) for stamps that differ by less than 0.1 s"
    ),
    r"create_node\(\) missing": "the node's name, e.g. create_node('my_node')",
    r"spin_once\(\) takes 1 positional": "spin_once(node, timeout_sec=1.0)",
    r"(Duration|Time)\.__init__\(\) (?:takes 1 positional|got)": "{}(seconds=1.5)",
    rf"{_UNSUPPORTED} [-+]=?: {_WITH_NUMBER}": "Duration(seconds=5.0) in place of a number",
    rf"{_UNSUPPORTED} -: 'Time' and 'Time'": (
        "Time.from_msg(message.header.stamp) for the time of a message"
    ),
    rf"{_UNSUPPORTED} //?=?: 'Duration' and {_NUMBER}": "a product, e.g. duration * 0.5",
    rf"{_UNSUPPORTED} //?=?: 'Duration' and 'Duration'": "a.nanoseconds / b.nanoseconds",
    rf"{_UNORDERED} (?:'Duration' and {_NUMBER}|{_NUMBER} and 'Duration')": (
        "duration.nanoseconds / 1e9 for the seconds of a duration"
    ),
    rf"{_UNORDERED} (?:'Time' and {_NUMBER}|{_NUMBER} and 'Time')": (
        "time.nanoseconds / 1e9 for the seconds of a time"
    ),
    # e.g. time.sleep(duration), int(duration)
    r"'Duration' object cannot be interpreted|(?:float|int)\(\) argument .*'Duration'": (
        "duration.nanoseconds / 1e9 for the seconds of a duration"
    ),
    r"module\(\) takes at most 2 arguments": "the class in the module, e.g. {Node}",
    r"'module' object is not callable": "the class or function in the module, e.g. {Node}",
    r"descriptor '__init__' requires a 'super' object": (
        "super().__init__(...), with parentheses after super"
    ),
    # `/` and others with a parameter in place of its value
    r"'Parameter' object cannot be|(?!'Parameter' object).*'Parameter'(?! object)": (
        "get_parameter('name').value"
    ),
    r"no running event loop\Z": (
        "self.create_timer(1.0, self.tick) in place of asyncio.sleep(1): the callbacks of a node "
        "do not run in asyncio"
    ),
}


def advise_of_call(error: BaseException) -> None:
    """Add to an error about a call or an operator what to write, if this is known."""
    if type(error) not in {TypeError, RuntimeError}:
        return
    advice = _of_missing_argument(error) or _of_text(str(error))
    if advice:
        error.args = (f"{error}: {advice}",)


def _of_missing_argument(error: BaseException) -> str:
    missing = _MISSING.search(str(error))
    if missing is None or missing[2] not in _ARGUMENTS:
        return ""
    if missing[1] and missing[2] == "node":
        return f"write the node, e.g. {missing[1]}(self)".replace(".(", "(")
    advice = _ARGUMENTS[missing[2]].format(library=library_name())
    return _misspelt_init(error.__traceback__) or f"write {advice}"


def _of_text(text: str) -> str:
    for pattern, sentence in _SENTENCES.items():
        if match := re.match(pattern, text):
            node = "zbot.Node" if library_name() == "zbot" else "rclpy.node.Node"
            return "write " + sentence.format(*match.groups(""), Node=node)
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
