# Written by python -m zbot.compat.generator; do not edit.
"""Events of a launch."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.event import (
    ExecutionComplete,
    IncludeLaunchDescriptionEvent as IncludeLaunchDescription,
    Shutdown,
    TimerEvent,
)
from zbot.launch.process_event import matches_action

__all__ = [
    "ExecutionComplete",
    "IncludeLaunchDescription",
    "Shutdown",
    "TimerEvent",
    "matches_action",
]

if TYPE_CHECKING:
    from . import execution_complete as execution_complete
    from . import include_launch_description as include_launch_description
    from . import matchers as matchers
    from . import process as process
    from . import shutdown as shutdown
    from . import timer_event as timer_event
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "execution_complete",
            "include_launch_description",
            "matchers",
            "process",
            "shutdown",
            "timer_event",
        ),
    )[0]
