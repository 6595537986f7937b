# Written by python -m zbot.compat.generator; do not edit.
"""Functions that list nodes and their endpoints."""

from zbot.compat.graph_listing import (
    NodeName,
    TopicInfo,
    get_absolute_node_name,
    get_action_client_info,
    get_action_server_info,
    get_node_names,
    get_publisher_info,
    get_service_client_info,
    get_service_server_info,
    get_subscriber_info,
    parse_node_name,
)
from zbot.names import is_hidden as _is_hidden_name

__all__ = [
    "NodeName",
    "TopicInfo",
    "get_absolute_node_name",
    "get_action_client_info",
    "get_action_server_info",
    "get_node_names",
    "get_publisher_info",
    "get_service_client_info",
    "get_service_server_info",
    "get_subscriber_info",
    "parse_node_name",
]
