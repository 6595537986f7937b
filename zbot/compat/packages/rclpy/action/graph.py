# Written by python -m zbot.compat.generator; do not edit.
"""Functions that list the actions of the graph."""

from zbot.action.graph import (
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from zbot.node.node import Node

__all__ = [
    "Node",
    "get_action_client_names_and_types_by_node",
    "get_action_names_and_types",
    "get_action_server_names_and_types_by_node",
]
