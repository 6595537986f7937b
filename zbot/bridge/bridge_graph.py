"""Bridges in the graph of zbot, and the nodes and names that each of them shows there."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from zbot.bridge.side import NODE_PREFIX
from zbot.wire.tokens import EndpointToken

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.graph.snapshot import Token

#: First part of the enclave in the tokens that a bridge makes. The rest is the bridge's id.
BRIDGE_ENCLAVE = "/zbot_bridge/"


@dataclass
class BridgeView:
    """Names that a bridge shows in the graph."""

    nodes: set[str] = field(default_factory=set)  #: full names of nodes of the other side
    names: set[str] = field(default_factory=set)  #: topics and services that the bridge carries


def bridge_of(token: Token) -> str | None:
    """Return the id of the bridge that made a token, or `None`."""
    if token.enclave.startswith(BRIDGE_ENCLAVE):
        return token.enclave.removeprefix(BRIDGE_ENCLAVE)
    if token.node.startswith(NODE_PREFIX):
        return token.node.removeprefix(NODE_PREFIX)
    return None


def bridges_in(tokens: Iterable[Token]) -> dict[str, BridgeView]:
    """Return the bridges in a graph, by id."""
    found: dict[str, BridgeView] = {}
    for token in tokens:
        bridge = bridge_of(token)
        if bridge is None:
            continue
        view = found.setdefault(bridge, BridgeView())
        if token.enclave.startswith(BRIDGE_ENCLAVE):
            if isinstance(token, EndpointToken):
                view.names.add(token.name)
            else:
                view.nodes.add(token.full_node_name)
    return found
