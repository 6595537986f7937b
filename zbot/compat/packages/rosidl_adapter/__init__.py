"""ROS 2's `rosidl_adapter`: the part that reads .msg, .srv and .action files."""

from zbot.compat.submodules import submodules

__getattr__ = submodules(__name__, "parser")
