# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchContext`."""

from zbot.launch import LaunchContext

__all__ = [
    "LaunchContext",
]
