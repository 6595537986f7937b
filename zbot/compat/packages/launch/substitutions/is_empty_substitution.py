# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `IsEmptySubstitution`."""

from zbot.launch.substitutions import IsEmptySubstitution

__all__ = [
    "IsEmptySubstitution",
]
