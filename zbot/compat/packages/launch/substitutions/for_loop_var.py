# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ForEachVar` and `ForLoopIndex`."""

from zbot.launch.substitutions import ForEachVar, ForLoopIndex

__all__ = [
    "ForEachVar",
    "ForLoopIndex",
]
