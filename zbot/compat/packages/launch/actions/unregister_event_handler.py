# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `UnregisterEventHandler`."""

from zbot.launch.actions import UnregisterEventHandler

__all__ = [
    "UnregisterEventHandler",
]
