# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchConfiguration`."""

from zbot.launch.substitutions import LaunchConfiguration

__all__ = [
    "LaunchConfiguration",
]
