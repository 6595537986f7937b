# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `LifecycleTransition`."""

from zbot.launch.actions import LifecycleTransition

__all__ = [
    "LifecycleTransition",
]
