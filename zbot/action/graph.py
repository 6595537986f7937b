"""Functions of rclpy that list the actions in the graph, or the actions of one node."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from zbot.graph.snapshot import full_names
from zbot.names import fully_qualified
from zbot.node.errors import UnknownNodeError
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from zbot.graph.snapshot import NamesAndTypes
    from zbot.node.node import Node


def get_action_names_and_types(node: Node) -> NamesAndTypes:
    """Return the name and types of every action that has a server or a client."""
    return node.context.graph.snapshot().actions()


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions that a node serves.

    Raises:
        UnknownNodeError: There is no such node.
    """
    return _of_node(node, EntityKind.SERVICE, remote_node_name, remote_node_namespace)


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """Return the actions for which a node has a client.

    Raises:
        UnknownNodeError: There is no such node.
    """
    return _of_node(node, EntityKind.CLIENT, remote_node_name, remote_node_namespace)


def _of_node(
    node: Node,
    kind: Literal[EntityKind.SERVICE, EntityKind.CLIENT],
    name: str,
    namespace: str,
) -> NamesAndTypes:
    snapshot = node.context.graph.snapshot()
    full = fully_qualified(namespace, name)
    if full not in full_names(snapshot.nodes):
        raise UnknownNodeError(full, full_names(snapshot.nodes))
    return snapshot.actions(kind, node=full)
