# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `InvalidLaunchFileError`."""

from zbot.launch.errors import InvalidLaunchFileError

__all__ = [
    "InvalidLaunchFileError",
]
