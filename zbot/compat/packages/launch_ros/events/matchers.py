# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `matches_node_name`."""

from zbot.launch.actions.lifecycle_node import matches_node_name

__all__ = [
    "matches_node_name",
]
