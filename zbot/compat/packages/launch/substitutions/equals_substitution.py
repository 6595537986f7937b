# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `EqualsSubstitution`."""

from zbot.launch.substitutions import EqualsSubstitution

__all__ = [
    "EqualsSubstitution",
]
