# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `StringJoinSubstitution`."""

from zbot.launch.substitutions import StringJoinSubstitution

__all__ = [
    "StringJoinSubstitution",
]
