# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `IfElseSubstitution`."""

from zbot.launch.substitutions import IfElseSubstitution

__all__ = [
    "IfElseSubstitution",
]
