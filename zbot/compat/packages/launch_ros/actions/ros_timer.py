# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `RosTimer`."""

from zbot.launch.actions import RosTimer

__all__ = [
    "RosTimer",
]
