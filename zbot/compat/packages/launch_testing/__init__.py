# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `launch_testing`: tests of launch files."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.testing.marker import parametrize, post_shutdown_test, ready_to_test_action_timeout
from zbot.launch.testing.record import (
    ExitRecord as ActiveProcInfoHandler,
    ExitRecord as ProcInfoHandler,
    OutputRecord as ActiveIoHandler,
    OutputRecord as IoHandler,
)

__all__ = [
    "ActiveIoHandler",
    "ActiveProcInfoHandler",
    "IoHandler",
    "ProcInfoHandler",
    "parametrize",
    "post_shutdown_test",
    "ready_to_test_action_timeout",
]

if TYPE_CHECKING:
    from . import actions as actions
    from . import asserts as asserts
    from . import event_handlers as event_handlers
    from . import io_handler as io_handler
    from . import launch_test as launch_test
    from . import loader as loader
    from . import markers as markers
    from . import proc_info_handler as proc_info_handler
    from . import test_runner as test_runner
    from . import tools as tools
    from . import util as util
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
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
        ),
    )[0]
