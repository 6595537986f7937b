# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `NotEqualsSubstitution`."""

from zbot.launch.substitutions import NotEqualsSubstitution

__all__ = [
    "NotEqualsSubstitution",
]
