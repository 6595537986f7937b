# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LogDebug`."""

from zbot.launch.actions import LogDebug

__all__ = [
    "LogDebug",
]
