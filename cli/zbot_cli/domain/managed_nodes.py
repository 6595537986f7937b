"""Client of the managed nodes' services for states and transitions."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from zbot.errors import ZbotError
from zbot.errors.suggestion import did_you_mean
from zbot.names import fully_qualified, is_hidden
from zbot_cli.domain.client import full_name

from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetAvailableTransitions, GetState

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from zbot.executor.task import Future
    from zbot.graph.snapshot import Snapshot
    from zbot.node.client import Client
    from zbot.node.node import Node

    from lifecycle_msgs.msg import State, TransitionDescription

ANSWER_TIMEOUT_S = 5.0  #: for each answer; a transition's callback has no time limit
_GET_STATE = "lifecycle_msgs/srv/GetState"


class NodeNotFoundError(ZbotError):
    """No managed node of that name appeared in time. The hint contains a similar name."""

    def __init__(self, name: str, graph: Snapshot) -> None:
        self.name = name
        known = managed_nodes(graph, include_hidden=True)
        names = [_name(node.namespace, node.node) for node in graph.nodes]
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


class NodeSilentError(ZbotError):
    """A managed node does not answer, or ended before it answered."""

    def __init__(self, node: str, reason: object) -> None:
        self.node, self.reason = node, reason
        super().__init__(f"Exception while calling service of node '{node}': {reason}")


class UnknownTransitionError(ZbotError):
    """The transition is not possible in the node's present state."""

    def __init__(self, wanted: str, possible: Sequence[TransitionDescription]) -> None:
        self.wanted = wanted
        labels = [one.transition.label for one in possible]
        self.hint = did_you_mean(wanted, labels)
        rows = [f"- {one.transition.label} [{one.transition.id}]" for one in possible]
        super().__init__("\n".join(("Unknown transition requested, available ones are:", *rows)))


class TransitionFailedError(ZbotError):
    """The transition's callback failed, or the state changed before the transition started."""

    def __init__(self, node: str, state: State) -> None:
        self.node, self.state = node, state
        self.hint = f"{node} is {state.label} now; see its log for the reason"
        super().__init__("Transitioning failed")


def managed_nodes(graph: Snapshot, *, include_hidden: bool) -> list[str]:
    """Return the full names of the managed nodes, sorted."""
    offered = {name for name, types in graph.services() if _GET_STATE in types}
    return sorted(
        {
            name
            for node in graph.nodes
            if f"{(name := _name(node.namespace, node.node))}/get_state" in offered
            and (include_hidden or not is_hidden(fully_qualified("/", node.node)))
        }
    )


def _name(namespace: str, node: str) -> str:
    return fully_qualified(namespace, node)


class ManagedNodes:
    """Client of the managed nodes of the domain.

    Args:
        node: The node that sends the requests.
        timeout_s: Seconds to wait for a node that is not running yet.
    """

    def __init__(self, node: Node, timeout_s: float) -> None:
        self._node = node
        self._timeout_s = timeout_s

    def all(self, *, include_hidden: bool) -> list[str]:
        """Return the full names of the running managed nodes."""
        return managed_nodes(self._node.context.graph.snapshot(), include_hidden=include_hidden)

    def find(self, name: str) -> str:
        """Return a node's full name as soon as it is running.

        Raises:
            NodeNotFoundError: The node does not appear in time.
        """
        full = full_name(name)
        graph = self._node.context.graph
        if not graph.wait_for(
            lambda now: full in managed_nodes(now, include_hidden=True), self._timeout_s
        ):
            raise NodeNotFoundError(full, graph.snapshot())
        return full

    def states(self, nodes: Iterable[str]) -> dict[str, State | NodeSilentError]:
        """Return each node's state, or an error for a silent node. Ask all nodes in parallel."""
        pending = {}
        states: dict[str, State | NodeSilentError] = {}
        for name in nodes:
            try:
                client = self._client(name, GetState, "get_state")
                pending[name] = client.call_server_async(GetState.Request())
            except NodeSilentError as error:
                states[name] = error
        for name, future in pending.items():
            states[name] = _state(name, future)
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
        answer = self._ask(name, GetAvailableTransitions, service, request, ANSWER_TIMEOUT_S)
        found: list[TransitionDescription] = answer.available_transitions
        return found

    def change(self, name: str, wanted: str) -> None:
        """Make the transition with the label or number `wanted`.

        There is no time limit, because the transition's callback in the node may take long.

        Raises:
            UnknownTransitionError: The transition is not possible now.
            TransitionFailedError: The state did not change.
            NodeSilentError: The node does not answer, or ended before it answered.
        """
        possible = self.transitions(name, show_all=False)
        for one in possible:
            if wanted in {one.transition.label, str(one.transition.id)}:
                break
        else:
            raise UnknownTransitionError(wanted, possible)
        transition = Transition(id=one.transition.id, label=one.transition.label)
        request = ChangeState.Request(transition=transition)
        if not self._ask(name, ChangeState, "change_state", request, None).success:
            raise TransitionFailedError(name, self.state(name))

    def _ask(
        self, node: str, srv_type: type[Any], service: str, request: Any, timeout_s: float | None
    ) -> Any:
        client = self._client(node, srv_type, service)
        try:
            return client.call(request, timeout_sec=timeout_s)
        except TimeoutError:
            raise _silent(node) from None
        except ZbotError as error:
            raise NodeSilentError(node, error) from error

    def _client(self, node: str, srv_type: type[Any], service: str) -> Client[Any, Any]:
        client = self._node.create_client(srv_type, f"{node}/{service}")
        if not client.wait_for_service(ANSWER_TIMEOUT_S):
            raise NodeSilentError(node, f"it has no {node}/{service}")
        return client


def _silent(node: str) -> NodeSilentError:
    return NodeSilentError(node, f"no answer in {ANSWER_TIMEOUT_S:g} s; does it spin?")


def _state(node: str, future: Future[Any]) -> State | NodeSilentError:
    over = threading.Event()
    future.add_waker(over.set)
    if not over.wait(ANSWER_TIMEOUT_S):
        return _silent(node)
    try:
        response: Any = future.result()
    except ZbotError as error:
        return NodeSilentError(node, error)
    state: State = response.current_state
    return state
