"""ROS 2's `launch_testing`: tests of launch files."""

from zbot.compat.submodules import submodules
from zbot.launch.testing.marker import parametrize, post_shutdown_test, ready_to_test_action_timeout
from zbot.launch.testing.record import ExitRecord as ActiveProcInfoHandler
from zbot.launch.testing.record import ExitRecord as ProcInfoHandler
from zbot.launch.testing.record import OutputRecord as ActiveIoHandler
from zbot.launch.testing.record import OutputRecord as IoHandler

__all__ = [
    "ActiveIoHandler",
    "ActiveProcInfoHandler",
    "IoHandler",
    "ProcInfoHandler",
    "parametrize",
    "post_shutdown_test",
    "ready_to_test_action_timeout",
]

__getattr__ = submodules(
    __name__,
    "actions",
    "asserts",
    "event_handlers",
    "io_handler",
    "launch_test",
    "loader",
    "markers",
    "proc_info_handler",
    "test_runner",
    "tools",
    "util",
)
