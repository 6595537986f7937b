# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `FindExecutable`."""

from zbot.launch.substitutions import FindExecutable

__all__ = [
    "FindExecutable",
]
