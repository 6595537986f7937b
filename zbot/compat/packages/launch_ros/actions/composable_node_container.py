# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `ComposableNodeContainer`."""

from zbot.launch.actions import ComposableNodeContainer

__all__ = [
    "ComposableNodeContainer",
]
