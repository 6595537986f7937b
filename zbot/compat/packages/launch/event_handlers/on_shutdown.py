# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnShutdown`."""

from zbot.launch.event_handler import OnShutdown

__all__ = [
    "OnShutdown",
]
