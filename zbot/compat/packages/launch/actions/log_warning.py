# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LogWarning`."""

from zbot.launch.actions import LogWarning

__all__ = [
    "LogWarning",
]
