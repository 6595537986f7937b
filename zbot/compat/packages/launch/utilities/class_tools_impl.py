# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `is_a` and `is_a_subclass` and `isclassinstance`."""

from zbot.compat.launch_utilities import is_a, is_a_subclass, isclassinstance

__all__ = [
    "is_a",
    "is_a_subclass",
    "isclassinstance",
]
