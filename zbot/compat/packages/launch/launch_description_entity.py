# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchDescriptionEntity`."""

from zbot.launch import LaunchDescriptionEntity

__all__ = [
    "LaunchDescriptionEntity",
]
