# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `EnvironmentVariable`."""

from zbot.launch.substitutions import EnvironmentVariable

__all__ = [
    "EnvironmentVariable",
]
