# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ReplaceEnvironmentVariables`."""

from zbot.launch.actions import ReplaceEnvironmentVariables

__all__ = [
    "ReplaceEnvironmentVariables",
]
