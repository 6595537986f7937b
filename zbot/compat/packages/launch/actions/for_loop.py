# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ForEach` and `ForLoop`."""

from zbot.launch.actions import ForEach, ForLoop

__all__ = [
    "ForEach",
    "ForLoop",
]
