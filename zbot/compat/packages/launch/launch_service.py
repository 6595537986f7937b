# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchService`."""

from zbot.launch import LaunchService

__all__ = [
    "LaunchService",
]
