"""Nodes with parameters that a command names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from zbot.remote.parameters import RemoteParameters, nodes_with_parameters, visible_nodes
from zbot.remote.service_calls import ANSWER_TIMEOUT_S, NoAnswerError, NoServiceError, ServiceCalls
from zbot_cli.domain.client import full_name, nobody_runs
from zbot_cli.errors import CommandError
from zbot_cli.input.domain_names import as_typed, did_you_mean

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.errors import ZbotError
    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node


def node_not_found_error(name: str, known: Sequence[str]) -> CommandError:
    """Return the error that no node of that name appeared in time.

    The hint has a similar name or the running nodes.
    """
    reason = did_you_mean(name, known) or _others(list(map(as_typed, known)))
    return CommandError("Node not found", hint=f"no node {as_typed(name)} is running; {reason}")


def _others(known: Sequence[str]) -> str:
    return f"running nodes are {', '.join(known)}" if known else nobody_runs()


class CommandParameters(RemoteParameters):
    """Client of the parameters of the nodes that a command names.

    Args:
        node: The node that sends the requests.
        timeout_s: Seconds to wait for a node that is not running yet.
        answer_timeout_s: Seconds to wait for each answer.
    """

    def __init__(
        self, node: Node, timeout_s: float, answer_timeout_s: float = ANSWER_TIMEOUT_S
    ) -> None:
        super().__init__(ServiceCalls(node, answer_timeout_s=answer_timeout_s))
        self._node, self._timeout_s = node, timeout_s

    def find(self, name: str) -> str:
        """Return a node's full name as soon as it is running.

        Raises:
            CommandError: The node does not appear in time.
        """
        full = full_name(name)
        if not self._node.wait_for_node(full, self._timeout_s):
            raise node_not_found_error(full, visible_nodes(self.graph()))
        return full

    def nodes(self, *, include_hidden: bool) -> list[str]:
        """Return the nodes that have parameter services."""
        return nodes_with_parameters(self.graph(), include_hidden=include_hidden)

    def graph(self) -> Snapshot:
        """Return the graph of the domain at this moment."""
        return self._node.context.graph.snapshot()


def in_words_of_ros2(error: ZbotError) -> ZbotError:
    """Return an error of a node's parameter services as ros2 says it. Other errors stay."""
    if not isinstance(error, (NoServiceError, NoAnswerError)):
        return error
    node = error.name.rpartition("/")[0]
    is_missing = isinstance(error, NoServiceError)
    reason = f"has no {error.name}" if is_missing else "does not answer: does it spin?"
    return CommandError(
        f"Wait for service timed out waiting for parameter services for node {node}",
        hint=f"{node} {reason}",
    )
