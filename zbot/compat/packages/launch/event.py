# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Event`."""

from zbot.launch import Event

__all__ = [
    "Event",
]
