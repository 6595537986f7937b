"""Nodes, and what each has."""

from zbot.compat.graph_listing import NodeName as NodeName
from zbot.compat.graph_listing import TopicInfo as TopicInfo
from zbot.compat.graph_listing import get_absolute_node_name as get_absolute_node_name
from zbot.compat.graph_listing import get_action_client_info as get_action_client_info
from zbot.compat.graph_listing import get_action_server_info as get_action_server_info
from zbot.compat.graph_listing import get_node_names as get_node_names
from zbot.compat.graph_listing import get_publisher_info as get_publisher_info
from zbot.compat.graph_listing import get_service_client_info as get_service_client_info
from zbot.compat.graph_listing import get_service_server_info as get_service_server_info
from zbot.compat.graph_listing import get_subscriber_info as get_subscriber_info
from zbot.compat.graph_listing import parse_node_name as parse_node_name
from zbot.names import is_hidden as _is_hidden_name
