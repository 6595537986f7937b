# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ThisLaunchFileDir`."""

from zbot.launch.substitutions import ThisLaunchFileDir

__all__ = [
    "ThisLaunchFileDir",
]
