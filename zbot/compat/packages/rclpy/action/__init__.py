"""Action servers and clients."""

from zbot.action.client import ActionClient as ActionClient
from zbot.action.graph import (
    get_action_client_names_and_types_by_node as get_action_client_names_and_types_by_node,
)
from zbot.action.graph import get_action_names_and_types as get_action_names_and_types
from zbot.action.graph import (
    get_action_server_names_and_types_by_node as get_action_server_names_and_types_by_node,
)
from zbot.action.server import ActionServer as ActionServer
from zbot.action.server import CancelResponse as CancelResponse
from zbot.action.server import GoalResponse as GoalResponse
from zbot.compat.submodules import submodules

__getattr__ = submodules(__name__, "client", "graph", "server")
