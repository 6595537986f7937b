# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchIntrospector`."""

from zbot.launch import LaunchIntrospector

__all__ = [
    "LaunchIntrospector",
]
