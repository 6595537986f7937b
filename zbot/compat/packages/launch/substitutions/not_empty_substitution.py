# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `NotEmptySubstitution`."""

from zbot.launch.substitutions import NotEmptySubstitution

__all__ = [
    "NotEmptySubstitution",
]
