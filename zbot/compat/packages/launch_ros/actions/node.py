# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `Node`."""

from zbot.launch.actions import Node

__all__ = [
    "Node",
]
