"""ROS 2's `launch_pytest`: launches as fixtures of pytest."""

from zbot.compat.submodules import submodules
from zbot.launch.testing.launch_fixture import fixture

__getattr__ = submodules(__name__, "actions", "tools")
