# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LifecycleNode`."""

from zbot.launch.actions import LifecycleNode

__all__ = [
    "LifecycleNode",
]
