# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchDescription`."""

from zbot.launch import LaunchDescription

__all__ = [
    "LaunchDescription",
]
