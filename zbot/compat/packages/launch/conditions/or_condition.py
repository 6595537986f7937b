# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OrCondition`."""

from zbot.launch.condition import OrCondition

__all__ = [
    "OrCondition",
]
