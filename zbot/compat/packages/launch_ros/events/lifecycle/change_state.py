# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ChangeState`."""

from zbot.launch.actions.lifecycle_node import ChangeState

__all__ = [
    "ChangeState",
]
