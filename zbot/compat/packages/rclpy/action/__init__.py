"""Action servers and clients."""

from zbot.action.client import ActionClient
from zbot.action.graph import (
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from zbot.action.server import ActionServer, CancelResponse, GoalResponse
from zbot.compat.submodules import submodules

__getattr__ = submodules(__name__, "client", "graph", "server")
