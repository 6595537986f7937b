"""Managed nodes in launch files: told to change their state, heard of when they did."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.launch.event import Event
from zbot.launch.event_handler import EventHandler

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.launch.actions.lifecycle_node import LifecycleNode
    from zbot.launch.event_handler import Reaction

    NodeMatcher: TypeAlias = Callable[[Any], bool]


class ChangeState(Event):
    """Managed nodes are to change their state.

    Args:
        lifecycle_node_matcher: Picks them, e.g. `matches_action(node)`.
        transition_id: A constant of `lifecycle_msgs.msg.Transition`.
    """

    name = "launch_ros.events.lifecycle.ChangeState"

    def __init__(self, *, lifecycle_node_matcher: NodeMatcher, transition_id: int) -> None:
        self.lifecycle_node_matcher, self.transition_id = lifecycle_node_matcher, transition_id


class StateTransition(Event):
    """A managed node changed its state.

    Args:
        action: The node.
        msg: What it told: a `lifecycle_msgs.msg.TransitionEvent`.
    """

    name = "launch_ros.events.lifecycle.StateTransition"

    def __init__(self, *, action: LifecycleNode, msg: Any) -> None:
        self.action, self.msg = action, msg

    @property
    def transition(self) -> str:
        """The label of the transition."""
        return str(self.msg.transition.label)

    @property
    def start_state(self) -> str:
        """The label of the state before."""
        return str(self.msg.start_state.label)

    @property
    def goal_state(self) -> str:
        """The label of the state now."""
        return str(self.msg.goal_state.label)


class OnStateTransition(EventHandler):
    """Acts when a managed node changes its state.

    Args:
        entities: What to do.
        target_lifecycle_node: The node; any if left out.
        transition: Label of the transition; any if left out.
        start_state: Label of the state before; any if left out.
        goal_state: Label of the state after; any if left out.
    """

    def __init__(
        self,
        *,
        entities: Reaction,
        target_lifecycle_node: LifecycleNode | None = None,
        transition: str | None = None,
        start_state: str | None = None,
        goal_state: str | None = None,
        **options: Any,
    ) -> None:
        self._target = target_lifecycle_node
        self._wanted = {
            "transition": transition,
            "start_state": start_state,
            "goal_state": goal_state,
        }
        super().__init__(matcher=self._is_meant, entities=entities, **options)

    def _is_meant(self, event: Event) -> bool:
        if not isinstance(event, StateTransition):
            return False
        if self._target is not None and event.action is not self._target:
            return False
        wanted = self._wanted.items()
        return all(value is None or getattr(event, name) == value for name, value in wanted)


def matches_node_name(node_name: str) -> NodeMatcher:
    """Return a matcher that picks nodes by their full name."""
    full = node_name if node_name.startswith("/") else f"/{node_name}"
    return lambda action: getattr(action, "node_name", None) == full
