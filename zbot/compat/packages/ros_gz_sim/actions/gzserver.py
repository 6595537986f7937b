# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `GzServer`."""

from zbot.launch.actions.gazebo import GzServer

__all__ = [
    "GzServer",
]
