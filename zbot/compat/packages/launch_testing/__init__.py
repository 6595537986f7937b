"""ROS 2's `launch_testing`, as far as launch files use it."""

from zbot.compat.submodules import submodules

__getattr__ = submodules(__name__, "actions")
