# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `DeclareBooleanLaunchArgument`."""

from zbot.launch.actions import DeclareBooleanLaunchArgument

__all__ = [
    "DeclareBooleanLaunchArgument",
]
