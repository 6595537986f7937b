# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `OnStateTransition`."""

from zbot.launch.actions.lifecycle_node import OnStateTransition

__all__ = [
    "OnStateTransition",
]
