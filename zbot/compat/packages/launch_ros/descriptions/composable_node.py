# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ComposableNode`."""

from zbot.launch.actions.composable import ComposableNode

__all__ = [
    "ComposableNode",
]
