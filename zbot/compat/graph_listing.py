"""Functions of ros2cli's Python packages about the graph.

By default, they skip hidden names. A name is hidden if one of its parts begins with `_`.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, NamedTuple

from zbot.action import graph as action_graph
from zbot.compat.rosidl.lookup import get_message, get_service
from zbot.errors import WrongStateError
from zbot.names import fully_qualified, is_hidden

if TYPE_CHECKING:
    from zbot.graph.snapshot import NamesAndTypes
    from zbot.node.node import Node


class NodeName(NamedTuple):
    """Name of a node: its parts, and the full name."""

    name: str
    namespace: str
    full_name: str


class TopicInfo(NamedTuple):
    """Name of a topic, service or action of a node, and its types."""

    name: str
    types: list[str]


def get_absolute_node_name(node_name: str) -> str | None:
    """Return the name with a leading slash, or None for an empty name."""
    return f"/{node_name.removeprefix('/')}" if node_name else None


def parse_node_name(node_name: str) -> NodeName:
    """Return the parts of a node's name. The name may lack the first slash."""
    full = f"/{node_name.removeprefix('/')}"
    namespace, _, name = full.rpartition("/")
    return NodeName(name, namespace or "/", full)


def get_node_names(*, node: Node, include_hidden_nodes: bool = False) -> list[NodeName]:
    """Return the nodes in the graph."""
    return [
        NodeName(name, namespace, fully_qualified(namespace, name))
        for name, namespace in node.get_node_names_and_namespaces()
        if include_hidden_nodes or not is_hidden(name)
    ]


def get_publisher_info(
    *, node: Node, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the topics that a node publishes on.

    Raises:
        UnknownNodeError: There is no such node.
    """
    name, namespace, _ = parse_node_name(remote_node_name)
    return _infos(node.get_publisher_names_and_types_by_node(name, namespace), include_hidden)


def get_subscriber_info(
    *, node: Node, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the topics that a node subscribes to. See `get_publisher_info`."""
    name, namespace, _ = parse_node_name(remote_node_name)
    return _infos(node.get_subscriber_names_and_types_by_node(name, namespace), include_hidden)


def get_service_server_info(
    *, node: Node, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the services that a node serves. See `get_publisher_info`."""
    name, namespace, _ = parse_node_name(remote_node_name)
    return _infos(node.get_service_names_and_types_by_node(name, namespace), include_hidden)


def get_service_client_info(
    *, node: Node, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the services that a node is a client of. See `get_publisher_info`."""
    name, namespace, _ = parse_node_name(remote_node_name)
    return _infos(node.get_client_names_and_types_by_node(name, namespace), include_hidden)


def get_action_server_info(
    *, node: Node, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the actions that a node serves. See `get_publisher_info`."""
    name, namespace, _ = parse_node_name(remote_node_name)
    found = action_graph.get_action_server_names_and_types_by_node(node, name, namespace)
    return _infos(found, include_hidden)


def get_action_client_info(
    *, node: Node, remote_node_name: str, include_hidden: bool = False
) -> list[TopicInfo]:
    """Return the actions that a node is a client of. See `get_publisher_info`."""
    name, namespace, _ = parse_node_name(remote_node_name)
    found = action_graph.get_action_client_names_and_types_by_node(node, name, namespace)
    return _infos(found, include_hidden)


def get_topic_names_and_types(*, node: Node, include_hidden_topics: bool = False) -> NamesAndTypes:
    """Return the topics in the graph, each with its types."""
    return _shown(node.get_topic_names_and_types(), include_hidden_topics)


def get_topic_names(*, node: Node, include_hidden_topics: bool = False) -> list[str]:
    """Return the names of the topics in the graph."""
    found = get_topic_names_and_types(node=node, include_hidden_topics=include_hidden_topics)
    return [name for name, _ in found]


def get_service_names_and_types(
    *, node: Node, include_hidden_services: bool = False
) -> NamesAndTypes:
    """Return the services in the graph, each with its types."""
    return _shown(node.get_service_names_and_types(), include_hidden_services)


def get_service_names(*, node: Node, include_hidden_services: bool = False) -> list[str]:
    """Return the names of the services in the graph."""
    found = get_service_names_and_types(node=node, include_hidden_services=include_hidden_services)
    return [name for name, _ in found]


def get_action_names_and_types(*, node: Node) -> NamesAndTypes:
    """Return the actions in the graph, each with its types."""
    return action_graph.get_action_names_and_types(node)


def get_action_names(*, node: Node) -> list[str]:
    """Return the names of the actions in the graph."""
    return [name for name, _ in get_action_names_and_types(node=node)]


def get_msg_class(
    node: Node, topic: str, blocking: bool = False, include_hidden_topics: bool = False
) -> type[Any] | None:
    """Return the class of a topic's messages, or None if no node uses the topic.

    Args:
        node: The node whose context has the graph.
        topic: Relative, `~/private` or absolute name.
        blocking: Whether to wait until a node uses the topic, or until the context of `node` ends.
        include_hidden_topics: Whether to find hidden topics too.

    Raises:
        InvalidTopicNameError: The name does not follow ROS 2's rules.
        WrongStateError: The topic has several types. The error is also a RuntimeError.
    """
    name = node.resolve_topic_name(topic, only_expand=True)
    if is_hidden(name) and not include_hidden_topics:
        return None
    found = _type_in(node.get_topic_names_and_types(), name)
    if found is None:
        print(f"WARNING: topic [{topic}] does not appear to be published yet", file=sys.stderr)
    while blocking and found is None and node.context.is_running:
        node.context.graph.wait_for(lambda now: name in dict(now.topics()), None)
        found = _type_in(node.get_topic_names_and_types(), name)
    return None if found is None else get_message(found)


def get_service_class(
    node: Node, service: str, blocking: bool = False, include_hidden_services: bool = False
) -> type[Any] | None:
    """Return the class of a service, or None if no node has this service. See `get_msg_class`."""
    name = node.resolve_service_name(service, only_expand=True)
    if is_hidden(name) and not include_hidden_services:
        return None
    found = _type_in(node.get_service_names_and_types(), name)
    if found is None:
        print(f"WARNING: service [{service}] does not appear to be available yet", file=sys.stderr)
    while blocking and found is None and node.context.is_running:
        node.context.graph.wait_for(lambda now: name in dict(now.services()), None)
        found = _type_in(node.get_service_names_and_types(), name)
    return None if found is None else get_service(found)


def _type_in(names_and_types: NamesAndTypes, name: str) -> str | None:
    types = dict(names_and_types).get(name)
    if types is None:
        return None
    if len(types) > 1:
        raise WrongStateError(f"'{name}' has more than one type: {', '.join(types)}")
    return types[0]


def _shown(found: NamesAndTypes, include_hidden: bool) -> NamesAndTypes:
    return [(name, types) for name, types in found if include_hidden or not is_hidden(name)]


def _infos(found: NamesAndTypes, include_hidden: bool) -> list[TopicInfo]:
    return [TopicInfo(name, types) for name, types in _shown(found, include_hidden)]
