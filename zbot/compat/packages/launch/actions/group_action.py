# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `GroupAction`."""

from zbot.launch.actions import GroupAction

__all__ = [
    "GroupAction",
]
