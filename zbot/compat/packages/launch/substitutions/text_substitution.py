# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `TextSubstitution`."""

from zbot.launch.substitutions import TextSubstitution

__all__ = [
    "TextSubstitution",
]
