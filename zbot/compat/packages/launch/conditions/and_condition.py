# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `AndCondition`."""

from zbot.launch.condition import AndCondition

__all__ = [
    "AndCondition",
]
