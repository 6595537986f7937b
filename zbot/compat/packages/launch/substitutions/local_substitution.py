# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LocalSubstitution`."""

from zbot.launch.substitutions import LocalSubstitution

__all__ = [
    "LocalSubstitution",
]
