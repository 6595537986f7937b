# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `add_node_name` and `get_node_name_count`."""

from zbot.launch.actions.node import add_node_name, get_node_name_count

__all__ = [
    "add_node_name",
    "get_node_name_count",
]
