"""Actions for managed (lifecycle) nodes and their transitions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

from zbot.launch.action import Action
from zbot.launch.actions.node import Node
from zbot.launch.errors import EntityTypeError
from zbot.launch.event import Event
from zbot.launch.event_handler import EventHandler
from zbot.launch.process_event import matches_action
from zbot.text.whole_number import whole_number

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.event_handler import Reaction
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.ros_node import LaunchNode
    from zbot.launch.substitution import SomeSubstitutionsType

    NodeMatcher: TypeAlias = Callable[[Any], bool]

#: The number and the goal state of each transition. The keys are the labels of the transitions.
_GOALS = {
    "configure": (1, "inactive"),
    "cleanup": (2, "unconfigured"),
    "activate": (3, "active"),
    "deactivate": (4, "inactive"),
    "unconfigured_shutdown": (5, "finalized"),
    "inactive_shutdown": (6, "finalized"),
    "active_shutdown": (7, "finalized"),
}
_LABELS = {number: label for label, (number, _) in _GOALS.items()}


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


class LifecycleNode(Node):
    """Run a managed node. Its name and namespace are required.

    Args:
        name: The node's name.
        namespace: The node's namespace.
        autostart: Whether to configure and activate the node after its start.
        options: The options of `Node`.
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        autostart: bool = False,
        **options: Any,
    ) -> None:
        super().__init__(name=name, namespace=namespace, **options)
        self.node_autostart = autostart

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the constructor options for a `lifecycle_node` tag."""
        from zbot.launch.frontend.ros_tags import lifecycle_node_options  # noqa: PLC0415 - cycle

        return cls, lifecycle_node_options(entity, parser)

    def execute(self, context: LaunchContext) -> list[Any] | None:
        """Start the node and listen to its transition events."""
        super().execute(context)
        is_started = bool(self.process_details)  # a program that cannot run in zbot is left out
        if context.is_shutdown or not is_started:
            return None
        from zbot.launch.ros_node import launch_node  # noqa: PLC0415 - imports Zenoh

        node = launch_node(context)
        node.listen(
            f"{self.node_name}/transition_event",
            lambda message: context.emit_event_sync(StateTransition(action=self, msg=message)),
        )
        context.register_event_handler(
            EventHandler(
                matcher=lambda event: (
                    isinstance(event, ChangeState) and event.lifecycle_node_matcher(self)
                ),
                entities=lambda event, _: self._change(event, context, node),
            )
        )
        if not self.node_autostart:
            return None
        return [LifecycleTransition([self], ["configure", "activate"])]

    def _change(self, event: ChangeState, context: LaunchContext, node: LaunchNode) -> None:
        label = _LABELS.get(event.transition_id, str(event.transition_id))

        def on_answer(succeeded: bool) -> None:
            if not succeeded:
                text = f"Failed to make transition '{label}' for LifecycleNode '{self.node_name}'"
                context.writer.error("launch_ros", text)

        node.change_state(self.node_name, event.transition_id, on_answer)


class LifecycleTransition(Action):
    """Request several transitions of managed nodes, one transition after the other.

    Args:
        lifecycle_node_names: The node actions, or full names of nodes.
        transition_ids: Labels or numbers of the transitions.

    Raises:
        EntityTypeError: A list is empty, or a transition does not exist.
    """

    def __init__(
        self,
        lifecycle_node_names: Iterable[Any],
        transition_ids: Iterable[int | str],
        **options: Any,
    ) -> None:
        super().__init__(**options)
        self._nodes = list(lifecycle_node_names)
        self._labels = [_label(transition_id) for transition_id in transition_ids]
        for what, given in (("nodes", self._nodes), ("transitions", self._labels)):
            if not given:
                raise EntityTypeError(f"the {what} of a LifecycleTransition", "at least one", given)

    def execute(self, context: LaunchContext) -> None:
        """Request the first transition of each node. Handlers request the next transitions."""
        for node in self._nodes:
            matcher = matches_action(node) if isinstance(node, Node) else matches_node_name(node)
            for before, label in zip(self._labels, self._labels[1:], strict=False):
                self._emit_after(context, matcher, _GOALS[before][1], label)
            self._emit(context, matcher, self._labels[0])

    @staticmethod
    def _emit(context: LaunchContext, matcher: Any, label: str) -> None:
        number = _GOALS[label][0]
        event = ChangeState(lifecycle_node_matcher=matcher, transition_id=number)
        context.emit_event_sync(event)

    def _emit_after(self, context: LaunchContext, matcher: Any, goal: str, label: str) -> None:
        class _AfterTransition(OnStateTransition):
            def matches(self, event: Any) -> bool:
                return super().matches(event) and matcher(event.action)

        context.register_event_handler(
            _AfterTransition(
                goal_state=goal,
                entities=lambda *_: self._emit(context, matcher, label),
                handle_once=True,
            )
        )


def _label(transition: int | str) -> str:
    number = transition if isinstance(transition, int) else whole_number(transition)
    label = str(transition) if number is None else _LABELS.get(number, "")
    if label not in _GOALS:
        raise EntityTypeError("a transition", f"one of {', '.join(_GOALS)}", transition)
    return label
