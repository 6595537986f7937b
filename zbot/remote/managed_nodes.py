"""Client of managed nodes, for their states and transitions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.graph.snapshot import full_names
from zbot.remote.parameters import visible_nodes
from zbot.remote.service_calls import ANSWER_TIMEOUT_S, NoAnswerError, NoServiceError, ServiceCalls

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.graph.snapshot import Snapshot
    from zbot.node.node import Node

    from lifecycle_msgs.msg import State, TransitionDescription

_GET_STATE = "lifecycle_msgs/srv/GetState"


class NodeSilentError(ZbotError):
    """A managed node does not answer, or ended before it answered."""

    def __init__(self, node: str, error: ZbotError) -> None:
        self.node = node
        reason: object = error
        if isinstance(error, NoServiceError):
            reason = f"it has no {error.name}"
        elif isinstance(error, NoAnswerError):
            reason = f"no answer in {error.timeout_s:g} s; does it spin?"
        self.reason = reason
        super().__init__(f"Exception while calling service of node '{node}': {reason}")


class TransitionError(ZbotError):
    """A managed node did not make a transition, or it cannot make it in its present state."""


def unknown_transition_error(
    wanted: str, possible: Sequence[TransitionDescription]
) -> TransitionError:
    """Return the error that a transition is not possible in the node's present state."""
    hint = did_you_mean(wanted, [description.transition.label for description in possible])
    rows = [
        f"- {description.transition.label} [{description.transition.id}]"
        for description in possible
    ]
    text = "\n".join(("Unknown transition requested, available ones are:", *rows))
    return TransitionError(text, hint=hint)


def managed_nodes(graph: Snapshot, *, include_hidden: bool) -> list[str]:
    """Return the full names of the managed nodes, sorted."""
    offered = {name for name, types in graph.services() if _GET_STATE in types}
    names = full_names(graph.nodes) if include_hidden else visible_nodes(graph)
    return sorted({name for name in names if f"{name}/get_state" in offered})


class ManagedNodes:
    """Client of the managed nodes of the domain. Any thread may call the methods, which block.

    A node is given by its full name.

    Args:
        node: The node that sends the requests. It need not spin.
        server_timeout_s: Seconds to wait for a managed node that is not running yet.
    """

    def __init__(self, node: Node, *, server_timeout_s: float = ANSWER_TIMEOUT_S) -> None:
        self._calls = ServiceCalls(
            node, answer_timeout_s=ANSWER_TIMEOUT_S, server_timeout_s=server_timeout_s
        )
        # The callback of a transition may take long.
        self._patient_calls = ServiceCalls(
            node, answer_timeout_s=None, server_timeout_s=server_timeout_s
        )

    def states(self, nodes: Iterable[str]) -> dict[str, State | NodeSilentError]:
        """Return each node's state, or an error for a silent node. Ask all nodes in parallel."""
        names = {f"{node}/get_state": node for node in nodes}
        answers = self._calls.call_all(GetState, dict.fromkeys(names, GetState.Request()))
        states: dict[str, State | NodeSilentError] = {}
        for name, node in names.items():
            answer = answers.found.get(name)
            states[node] = (
                NodeSilentError(node, answers.errors[name])
                if answer is None
                else answer.current_state
            )
        return states

    def state(self, name: str) -> State:
        """Return the state of a node.

        Raises:
            NodeSilentError: The node does not answer.
        """
        answer = self.states([name])[name]
        if isinstance(answer, NodeSilentError):
            raise answer
        return answer

    def transitions(self, name: str, *, show_all: bool) -> list[TransitionDescription]:
        """Return the transitions that are possible now, or all transitions of the node.

        Raises:
            NodeSilentError: The node does not answer.
        """
        service = "get_transition_graph" if show_all else "get_available_transitions"
        request = GetAvailableTransitions.Request()
        answer = _ask(self._calls, name, service, GetAvailableTransitions, request)
        found: list[TransitionDescription] = answer.available_transitions
        return found

    def change(self, name: str, wanted: str) -> None:
        """Make the transition with the label or number `wanted`.

        There is no time limit, because the transition's callback in the node may take long.

        Raises:
            TransitionError: The transition is not possible now, or the state did not change.
            NodeSilentError: The node does not answer, or ended before it answered.
        """
        possible = self.transitions(name, show_all=False)
        for description in possible:
            if wanted in {description.transition.label, str(description.transition.id)}:
                break
        else:
            raise unknown_transition_error(wanted, possible)
        if not self.request(name, description.transition.id, description.transition.label):
            hint = f"{name} is {self.state(name).label} now; see its log for the reason"
            raise TransitionError("Transitioning failed", hint=hint)

    def request(self, name: str, number: int, label: str = "") -> bool:
        """Request a transition by its number. Return whether the node made it.

        There is no time limit, as in `change`.

        Raises:
            NodeSilentError: The node does not answer, or ended before it answered.
        """
        request = ChangeState.Request(transition=Transition(id=number, label=label))
        answer = _ask(self._patient_calls, name, "change_state", ChangeState, request)
        return bool(answer.success)


def _ask(calls: ServiceCalls, node: str, service: str, srv_type: type[Any], request: Any) -> Any:
    try:
        return calls.call(f"{node}/{service}", srv_type, request)
    except ZbotError as error:
        raise NodeSilentError(node, error) from error
