# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `UnlessCondition`."""

from zbot.launch.condition import UnlessCondition

__all__ = [
    "UnlessCondition",
]
