# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PathJoinSubstitution`."""

from zbot.launch.substitutions import PathJoinSubstitution

__all__ = [
    "PathJoinSubstitution",
]
