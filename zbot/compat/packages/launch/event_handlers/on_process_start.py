# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnProcessStart`."""

from zbot.launch.event_handler import OnProcessStart

__all__ = [
    "OnProcessStart",
]
