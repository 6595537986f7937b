"""Managed nodes that a command names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.graph.snapshot import full_names
from zbot.remote.managed_nodes import managed_nodes
from zbot_cli.domain.client import full_name

if TYPE_CHECKING:
    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node


class NodeNotFoundError(ZbotError):
    """No managed node of that name appeared in time. The hint contains a similar name."""

    def __init__(self, name: str, graph: Snapshot) -> None:
        self.name = name
        known = managed_nodes(graph, include_hidden=True)
        names = full_names(graph.nodes)
        guess = did_you_mean(name, known) or did_you_mean(name, names)
        if name in names:
            self.hint = f"{name} is running, but it is not a managed node"
        elif guess:
            self.hint = f"no node {name} is running; {guess}"
        else:
            others = ", ".join(known)
            self.hint = f"no node {name} is running; " + (
                f"managed nodes are {others}" if others else "no managed node is running"
            )
        super().__init__("Node not found")


def find_managed_node(node: Node, name: str, timeout_s: float) -> str:
    """Return a managed node's full name as soon as it is running.

    Args:
        node: The node of the command.
        name: The name on the command line.
        timeout_s: Seconds to wait for a node that is not running yet.

    Raises:
        NodeNotFoundError: The node does not appear in time.
    """
    full, graph = full_name(name), node.context.graph
    if not graph.wait_for(lambda now: full in managed_nodes(now, include_hidden=True), timeout_s):
        raise NodeNotFoundError(full, graph.snapshot())
    return full
