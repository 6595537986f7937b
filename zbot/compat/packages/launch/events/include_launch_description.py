# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `IncludeLaunchDescription`."""

from zbot.launch.event import IncludeLaunchDescriptionEvent as IncludeLaunchDescription

__all__ = [
    "IncludeLaunchDescription",
]
