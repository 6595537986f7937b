# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LogError`."""

from zbot.launch.actions import LogError

__all__ = [
    "LogError",
]
