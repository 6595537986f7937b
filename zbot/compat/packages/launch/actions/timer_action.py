# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `TimerAction`."""

from zbot.launch.actions import TimerAction

__all__ = [
    "TimerAction",
]
