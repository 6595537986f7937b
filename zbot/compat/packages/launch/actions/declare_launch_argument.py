# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `DeclareLaunchArgument`."""

from zbot.launch.actions import DeclareLaunchArgument

__all__ = [
    "DeclareLaunchArgument",
]
