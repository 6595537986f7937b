# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LaunchLogDir`."""

from zbot.launch.substitutions import LaunchLogDir

__all__ = [
    "LaunchLogDir",
]
