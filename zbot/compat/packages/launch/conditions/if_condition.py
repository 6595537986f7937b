# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `IfCondition`."""

from zbot.launch.condition import IfCondition

__all__ = [
    "IfCondition",
]
