# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `RunningProcessEvent`."""

from zbot.launch.process_event import RunningProcessEvent

__all__ = [
    "RunningProcessEvent",
]
