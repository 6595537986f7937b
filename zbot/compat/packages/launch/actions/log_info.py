# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LogInfo`."""

from zbot.launch.actions import LogInfo

__all__ = [
    "LogInfo",
]
