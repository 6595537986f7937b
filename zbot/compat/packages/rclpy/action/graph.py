"""Which actions there are."""

from zbot.action.graph import (
    get_action_client_names_and_types_by_node as get_action_client_names_and_types_by_node,
)
from zbot.action.graph import get_action_names_and_types as get_action_names_and_types
from zbot.action.graph import (
    get_action_server_names_and_types_by_node as get_action_server_names_and_types_by_node,
)
from zbot.node.node import Node as Node
