# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `StateTransition`."""

from zbot.launch.actions.lifecycle_node import StateTransition

__all__ = [
    "StateTransition",
]
