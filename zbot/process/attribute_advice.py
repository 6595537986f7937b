"""Advice for a name that rclpy does not have: `rclpy.Publisher`, `self.get_logger.info("x")`.

Python names the attribute that is missing, but not what to write. Many such names are those of
ROS 1.
"""

from __future__ import annotations

import linecache
import re
import sys
from types import FunctionType, ModuleType

from zbot.errors import library_name
from zbot.errors.call_source import OWN_FILES
from zbot.errors.suggestion import did_you_mean

_NODE = "create_publisher"
_WAIT = "{}.spin_until_future_complete(node, future) before it, because the future is not done"
_IMPORT = re.compile(r"cannot import name '(\w+)' from '([\w.]+)'")
# The second form is that of Python 3.10.
_NO_SETTER = re.compile(
    r"(?:can't set attribute|property) '(\w+)'(?: of '(\w+)' object has no setter)?$"
)
#: Names of a node that a program cannot set.
_TAKEN = {"context", "default_callback_group", "handle", "name", "namespace", "waitables"}
#: What to write in place of setting an attribute, by its class and its name.
_INSTEAD_OF_SETTING = {
    ("Duration", "nanoseconds"): "a new one, e.g. Duration(seconds=1.5)",
    ("Parameter", "value"): "node.set_parameters([Parameter('speed', value=1.0)])",
    ("Time", "nanoseconds"): "a new one, e.g. Time(seconds=1.5)",
}
#: Methods that a program expects of its class only if the class is a node.
_ONLY_OF_NODE = {
    "create_client", "create_publisher", "create_rate", "create_service", "create_subscription",
    "create_timer", "declare_parameter", "declare_parameters", "get_clock", "get_logger",
    "get_parameter", "get_parameters",
}  # fmt: skip
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
    elif fixed := _NO_SETTER.match(str(error)):
        error.args = (f"{error}{_of_fixed(fixed[2], fixed[1])}",)


def _of_fixed(owner: str | None, name: str) -> str:
    """Return what to write in place of setting an attribute that cannot be set."""
    if advice := _INSTEAD_OF_SETTING.get((owner or "", name)):
        return f": write {advice}"
    advice = f": nodes use this name themselves; choose another, e.g. self.my_{name}"
    return advice if name in _TAKEN else ""


def advise_of_import(error: BaseException) -> None:
    """Add a similar name to an error about a name that one of zbot's modules does not have.

    Python would take the similar name from the top-level package: `node` for `rclpy.node.nod`.
    """
    if not isinstance(error, ImportError):
        return
    match = _IMPORT.match(str(error))
    module = sys.modules.get(match[2]) if match else None
    if match and str(getattr(module, "__file__", "")).startswith(OWN_FILES):
        names = [name for name in dir(module) if not name.startswith("_")]
        error.msg = f"{error}{did_you_mean(match[1], names, before='; ')}"
        error.name_from = None  # type: ignore[attr-defined,unused-ignore]  # since Python 3.12


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
    if trace is None or not str(error).startswith("'NoneType'"):
        return ""
    line = linecache.getline(trace.tb_frame.f_code.co_filename, trace.tb_lineno)
    is_result = f".result().{error.name}" in line.replace(" ", "")
    return _WAIT.format(library_name()) if is_result else ""


def _advice(obj: object, name: object) -> str:
    if not isinstance(name, str) or name.startswith("_"):
        return ""
    if isinstance(obj, ModuleType):
        is_library = obj.__name__ in {"rclpy", "zbot"}
        return _OF_MODULE.get(name, "").replace("rclpy.", f"{obj.__name__}.") if is_library else ""
    if isinstance(obj, FunctionType):  # also for a method, whose attributes are its function's
        is_ours = str(obj.__module__).startswith("zbot.")
        return f"{obj.__name__}().{name}, with parentheses" if is_ours else ""
    return "" if isinstance(obj, type) else _advice_for_object(obj, name)


def _advice_for_object(obj: object, name: str) -> str:
    if name in _ONLY_OF_NODE and (advice := _of_no_node(type(obj))):
        return advice
    if name in _SECONDS and hasattr(type(obj), "nanoseconds"):
        return "nanoseconds / 1e9"
    if name in {"sec", "nanosec"} and hasattr(type(obj), "to_msg"):
        return f"to_msg().{name}"
    if hasattr(getattr(obj, "request", None), name) and hasattr(type(obj), "publish_feedback"):
        return f"goal_handle.request.{name}"
    if hasattr(type(obj), _NODE):
        return _OF_NODE.get(name, "") or _getter(obj, name)
    if hasattr(type(obj), "add_done_callback") and name not in dir(obj):
        library = library_name()
        return f"result().{name}, after {library}.spin_until_future_complete(node, future)"
    return _getter(obj, name)


def _of_no_node(cls: type) -> str:
    """Return what to write if a class without a base class is used as a node."""
    if cls.__name__ == "InitContextManager":
        return "node = Node('my_node') for a node, because init() returns none"
    is_of_program = not cls.__module__.startswith(("builtins", "zbot."))
    return f"class {cls.__name__}(Node):" if is_of_program and cls.__bases__ == (object,) else ""


def _getter(obj: object, name: str) -> str:
    """Return `get_clock()` for `node.clock`, and `value` for `parameter.get_value()`."""
    bare = name.removeprefix("get_")
    if _is_ours(obj) and name != bare and hasattr(type(obj), bare):
        return bare
    return f"get_{name}()" if _is_ours(obj) and hasattr(type(obj), f"get_{name}") else ""
