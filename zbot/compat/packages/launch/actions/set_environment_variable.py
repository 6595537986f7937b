# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SetEnvironmentVariable`."""

from zbot.launch.actions import SetEnvironmentVariable

__all__ = [
    "SetEnvironmentVariable",
]
