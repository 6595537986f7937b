# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `GzSpawnModel`."""

from zbot.launch.actions.gazebo import GzSpawnModel

__all__ = [
    "GzSpawnModel",
]
