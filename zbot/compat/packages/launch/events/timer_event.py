# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `TimerEvent`."""

from zbot.launch.event import TimerEvent

__all__ = [
    "TimerEvent",
]
