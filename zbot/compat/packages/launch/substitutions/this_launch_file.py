# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ThisLaunchFile`."""

from zbot.launch.substitutions import ThisLaunchFile

__all__ = [
    "ThisLaunchFile",
]
