# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `PathSubstitution`."""

from zbot.launch.substitutions import PathSubstitution

__all__ = [
    "PathSubstitution",
]
