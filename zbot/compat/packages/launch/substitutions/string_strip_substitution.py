# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `StringStripSubstitution`."""

from zbot.launch.substitutions import StringStripSubstitution

__all__ = [
    "StringStripSubstitution",
]
