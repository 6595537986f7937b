"""Events of a launch."""

from zbot.compat.submodules import submodules
from zbot.launch.event import ExecutionComplete, Shutdown, TimerEvent
from zbot.launch.event import IncludeLaunchDescriptionEvent as IncludeLaunchDescription
from zbot.launch.process_event import matches_action

__all__ = [
    "ExecutionComplete",
    "IncludeLaunchDescription",
    "Shutdown",
    "TimerEvent",
    "matches_action",
]

__getattr__ = submodules(__name__, "process")
