"""Events that request or report transitions of managed (lifecycle) nodes."""

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
    """Request for a transition of managed nodes.

    Args:
        lifecycle_node_matcher: Selects the nodes, e.g. `matches_action(node)`.
        transition_id: A constant of `lifecycle_msgs.msg.Transition`.
    """

    name = "launch_ros.events.lifecycle.ChangeState"

    def __init__(self, *, lifecycle_node_matcher: NodeMatcher, transition_id: int) -> None:
        self.lifecycle_node_matcher, self.transition_id = lifecycle_node_matcher, transition_id


class StateTransition(Event):
    """A managed node changed its state.

    Args:
        action: The node.
        msg: The node's `lifecycle_msgs.msg.TransitionEvent`.
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
        """The label of the state before the transition."""
        return str(self.msg.start_state.label)

    @property
    def goal_state(self) -> str:
        """The label of the state after the transition."""
        return str(self.msg.goal_state.label)


class OnStateTransition(EventHandler):
    """Reacts when a managed node changes its state.

    Args:
        entities: The reaction.
        target_lifecycle_node: The node. None means any node.
        transition: The label of the transition. None means any transition.
        start_state: The label of the state before the transition. None means any state.
        goal_state: The label of the state after the transition. None means any state.
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
        super().__init__(matcher=self._matches_target, entities=entities, **options)

    def _matches_target(self, event: Event) -> bool:
        if not isinstance(event, StateTransition):
            return False
        if self._target is not None and event.action is not self._target:
            return False
        wanted = self._wanted.items()
        return all(value is None or getattr(event, name) == value for name, value in wanted)


def matches_node_name(node_name: str) -> NodeMatcher:
    """Return a matcher that selects nodes by their full name."""
    full = node_name if node_name.startswith("/") else f"/{node_name}"
    return lambda action: getattr(action, "node_name", None) == full
