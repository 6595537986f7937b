# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnIncludeLaunchDescription`."""

from zbot.launch.event_handler import OnIncludeLaunchDescription

__all__ = [
    "OnIncludeLaunchDescription",
]
