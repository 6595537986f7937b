# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `create_future`."""

from zbot.compat.launch_utilities import create_future

__all__ = [
    "create_future",
]
