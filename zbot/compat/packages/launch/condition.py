# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Condition`."""

from zbot.launch import Condition

__all__ = [
    "Condition",
]
