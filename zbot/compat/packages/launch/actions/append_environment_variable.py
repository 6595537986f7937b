# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `AppendEnvironmentVariable`."""

from zbot.launch.actions import AppendEnvironmentVariable

__all__ = [
    "AppendEnvironmentVariable",
]
