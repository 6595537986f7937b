# Written by python -m zbot.compat.generator; do not edit.
"""Action servers and clients."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.action.client import ActionClient
from zbot.action.graph import (
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from zbot.action.server import ActionServer, CancelResponse, GoalResponse

__all__ = [
    "ActionClient",
    "ActionServer",
    "CancelResponse",
    "GoalResponse",
    "get_action_client_names_and_types_by_node",
    "get_action_names_and_types",
    "get_action_server_names_and_types_by_node",
]

if TYPE_CHECKING:
    from . import client as client
    from . import graph as graph
    from . import server as server
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "client",
            "graph",
            "server",
        ),
    )[0]
