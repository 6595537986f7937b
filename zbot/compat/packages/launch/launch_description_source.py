# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchDescriptionSource`."""

from zbot.launch import LaunchDescriptionSource

__all__ = [
    "LaunchDescriptionSource",
]
