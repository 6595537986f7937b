"""Advice for a name that rclpy does not have: `rclpy.Publisher`, `self.get_logger.info("x")`.

Python names the attribute that is missing, but not what to write. Many such names are those of
ROS 1.
"""

from __future__ import annotations

import linecache
import re
from types import FunctionType, ModuleType

from zbot.errors.suggestion import did_you_mean

_NODE = "create_publisher"
_WAIT = "rclpy.spin_until_future_complete(node, future) before it, because the future is not done"
# The second form is that of Python 3.10.
_NO_SETTER = re.compile(
    r"(?:can't set attribute|property) '(\w+)'(?: of '\w+' object has no setter)?$"
)
#: Names of a node that a program cannot set.
_TAKEN = {"context", "default_callback_group", "handle", "name", "namespace"}
#: What to write in place of a name of `rclpy`.
_OF_MODULE = {
    "Duration": "rclpy.duration.Duration",
    "Node": "rclpy.node.Node",
    "Publisher": "self.create_publisher(String, 'chatter', 10) in a node",
    "Rate": "self.create_rate(10) or self.create_timer(0.1, self.tick) in a node",
    "ServiceProxy": "self.create_client(Trigger, 'name') in a node",
    "Service": "self.create_service(Trigger, 'name', self.callback) in a node",
    "Subscriber": "self.create_subscription(String, 'chatter', self.callback, 10) in a node",
    "get_param": "self.get_parameter('name').value in a node",
    "init_node": "rclpy.init(), and then rclpy.create_node('name')",
    "is_shutdown": "not rclpy.ok()",
    "logdebug": "self.get_logger().debug('text') in a node",
    "logerr": "self.get_logger().error('text') in a node",
    "loginfo": "self.get_logger().info('text') in a node",
    "logwarn": "self.get_logger().warning('text') in a node",
    "sleep": "time.sleep(1), or self.create_timer(1.0, self.tick) in a node",
    "spinOnce": "rclpy.spin_once(node)",
}
_SECONDS = {"second", "seconds", "secs", "to_sec", "toSec"}  #: of a Time or Duration, as in ROS 1
#: What to write in place of a name of a node.
_OF_NODE = {
    "advertise": "create_publisher",
    "create_server": "create_service",
    "create_subscriber": "create_subscription",
    "create_service_client": "create_client",
    "destroy": "destroy_node",
    "get_param": "get_parameter",
    "publish": "self.publisher.publish(message), with the result of self.create_publisher()",
    "subscribe": "create_subscription",
}


def advise_of_attribute(error: BaseException) -> None:
    """Add to an error about an unknown attribute what to write, if this is known."""
    if not isinstance(error, AttributeError):
        return
    advice = _advice(error.obj, error.name) or _of_result(error)
    if advice:
        error.args = (f"{error}: write {advice}",)
        error.obj = None  # Python would suggest a name too
    elif str(error).startswith("'property' object has no attribute"):
        # `message = Twist`, and then `message.linear.x = 1.0`
        error.args = (f"{error}: write parentheses after the class, e.g. message = Twist()",)
    elif (taken := _NO_SETTER.match(str(error))) and taken[1] in _TAKEN:
        advice = f"nodes use this name themselves; choose another, e.g. self.my_{taken[1]}"
        error.args = (f"{error}: {advice}",)


def suggest_public_name(error: BaseException) -> None:
    """Add a similar public name to an error about an object of zbot, if it has no advice yet.

    Python up to 3.12 would also suggest private names.
    """
    if isinstance(error, AttributeError) and isinstance(error.name, str) and _is_ours(error.obj):
        names = [name for name in dir(error.obj) if not name.startswith("_")]
        error.args = (f"{error}{did_you_mean(error.name, names, before='; ')}",)
        error.obj = None


def _is_ours(obj: object) -> bool:
    """Return whether zbot has made the class of an object, or a base of it."""
    bases = () if isinstance(obj, (type, ModuleType)) else type(obj).__mro__
    return any(base.__module__.startswith("zbot.") for base in bases)


def _of_result(error: AttributeError) -> str:
    """Return what to write if a program uses the result of a future that is not done."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    if trace is None or error.obj is not None:
        return ""
    line = linecache.getline(trace.tb_frame.f_code.co_filename, trace.tb_lineno)
    is_result = f".result().{error.name}" in line.replace(" ", "")
    return _WAIT if is_result else ""


def _advice(obj: object, name: object) -> str:
    if not isinstance(name, str) or name.startswith("_"):
        return ""
    if isinstance(obj, ModuleType):
        return _OF_MODULE.get(name, "") if obj.__name__ == "rclpy" else ""
    if isinstance(obj, FunctionType):  # also for a method, whose attributes are its function's
        is_ours = str(obj.__module__).startswith("zbot.")
        return f"{obj.__name__}().{name}, with parentheses" if is_ours else ""
    return "" if isinstance(obj, type) else _advice_for_object(obj, name)


def _advice_for_object(obj: object, name: str) -> str:
    if name in _SECONDS and hasattr(type(obj), "nanoseconds"):
        return "nanoseconds / 1e9"
    if name in {"sec", "nanosec"} and hasattr(type(obj), "to_msg"):
        return f"to_msg().{name}"
    if hasattr(getattr(obj, "request", None), name) and hasattr(type(obj), "publish_feedback"):
        return f"goal_handle.request.{name}"
    if hasattr(type(obj), _NODE):
        return _OF_NODE.get(name, "") or _getter(obj, name)
    if hasattr(type(obj), "add_done_callback") and name not in dir(obj):
        return f"result().{name}, after rclpy.spin_until_future_complete(node, future)"
    return _getter(obj, name)


def _getter(obj: object, name: str) -> str:
    """Return `get_clock()` for `node.clock`, and `value` for `parameter.get_value()`."""
    bare = name.removeprefix("get_")
    if _is_ours(obj) and name != bare and hasattr(type(obj), bare):
        return bare
    return f"get_{name}()" if _is_ours(obj) and hasattr(type(obj), f"get_{name}") else ""
