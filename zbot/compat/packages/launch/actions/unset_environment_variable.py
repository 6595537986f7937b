# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `UnsetEnvironmentVariable`."""

from zbot.launch.actions import UnsetEnvironmentVariable

__all__ = [
    "UnsetEnvironmentVariable",
]
