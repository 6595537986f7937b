"""Services of a managed node, and the topic on which the node publishes its transitions."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from zbot.lifecycle.state_machine import (
    STATES,
    TRANSITIONS,
    TransitionCallbackReturn,
    TransitionNotPossibleError,
    transitions_from,
)
from zbot.node.node import Node

from lifecycle_msgs.msg import State, TransitionDescription, TransitionEvent
from lifecycle_msgs.msg import Transition as TransitionMsg
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.executor.callback_group import CallbackGroup
    from zbot.lifecycle.state_machine import LifecycleState, StateMachine, Transition

#: Depth of the publisher of transitions. It is the same as in ROS 2.
_EVENT_DEPTH = 10


class LifecycleServices:
    """Lets other programs read a node's state and change it.

    Args:
        node: The managed node.
        machine: Its state machine.
        change: Takes the number of a transition, makes the transition, and runs its callbacks.
        callback_group: Group of the services.
    """

    def __init__(
        self,
        node: Node,
        machine: StateMachine,
        change: Callable[[int], TransitionCallbackReturn],
        callback_group: CallbackGroup | None,
    ) -> None:
        self._machine = machine
        self._change = change
        # A program's class may override node.create_publisher, so Node's own method is called.
        self._events = Node.create_publisher(
            node, TransitionEvent, "~/transition_event", _EVENT_DEPTH
        )
        served: dict[str, tuple[type[Any], Callable[[Any, Any], Any]]] = {
            "change_state": (ChangeState, self._change_state),
            "get_state": (GetState, self._get_state),
            "get_available_states": (GetAvailableStates, self._get_states),
            "get_available_transitions": (GetAvailableTransitions, self._get_transitions),
            "get_transition_graph": (GetAvailableTransitions, self._get_graph),
        }
        for name, (srv_type, answer) in served.items():
            service = Node.create_service(
                node, srv_type, f"~/{name}", answer, callback_group=callback_group
            )
            setattr(machine, f"service_{name}", service)

    def publish_event(self, transition: Transition) -> None:
        """Publish a transition that was made. Do nothing if a callback has destroyed the node."""
        if not self._events.is_open:
            return
        event = TransitionEvent(timestamp=time.time_ns())
        event.transition.id = transition.transition_id
        event.transition.label = transition.label
        event.start_state = _state(transition.start)
        event.goal_state = _state(transition.goal)
        self._events.publish(event)

    def _change_state(
        self, request: ChangeState.Request, response: ChangeState.Response
    ) -> ChangeState.Response:
        wanted = request.transition.id
        if request.transition.label:  # the label has priority over the number
            try:
                wanted = self._machine.find(request.transition.label).transition_id
            except TransitionNotPossibleError:
                response.success = False
                return response
        response.success = self._change(wanted) is TransitionCallbackReturn.SUCCESS
        return response

    def _get_state(self, _: GetState.Request, response: GetState.Response) -> GetState.Response:
        response.current_state = _state(self._machine.state)
        return response

    def _get_states(
        self, _: GetAvailableStates.Request, response: GetAvailableStates.Response
    ) -> GetAvailableStates.Response:
        response.available_states = [_state(state) for state in STATES]
        return response

    def _get_transitions(
        self, _: GetAvailableTransitions.Request, response: GetAvailableTransitions.Response
    ) -> GetAvailableTransitions.Response:
        response.available_transitions = _descriptions(transitions_from(self._machine.state))
        return response

    def _get_graph(
        self, _: GetAvailableTransitions.Request, response: GetAvailableTransitions.Response
    ) -> GetAvailableTransitions.Response:
        response.available_transitions = _descriptions(TRANSITIONS)
        return response


def _state(state: LifecycleState) -> State:
    return State(id=state.state_id, label=state.label)


def _descriptions(transitions: Iterable[Transition]) -> list[TransitionDescription]:
    return [
        TransitionDescription(
            transition=TransitionMsg(id=transition.transition_id, label=transition.label),
            start_state=_state(transition.start),
            goal_state=_state(transition.goal),
        )
        for transition in transitions
    ]
