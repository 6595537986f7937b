"""Actions for managed (lifecycle) nodes and their transitions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.actions.node import Node
from zbot.launch.errors import EntityTypeError
from zbot.launch.event_handler import EventHandler
from zbot.launch.lifecycle_event import ChangeState, OnStateTransition, StateTransition
from zbot.launch.process_event import matches_action

if TYPE_CHECKING:
    from collections.abc import Iterable

    from zbot.launch.context import LaunchContext
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser
    from zbot.launch.ros_node import LaunchNode
    from zbot.launch.substitution import SomeSubstitutionsType

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
        self._labels = [_label(one) for one in transition_ids]
        for what, given in (("nodes", self._nodes), ("transitions", self._labels)):
            if not given:
                raise EntityTypeError(f"the {what} of a LifecycleTransition", "at least one", given)

    def execute(self, context: LaunchContext) -> None:
        """Request the first transition of each node. Handlers request the next transitions."""
        for node in self._nodes:
            matcher = matches_action(node) if isinstance(node, Node) else _by_name(node)
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


def _by_name(name: str) -> Any:
    from zbot.launch.lifecycle_event import matches_node_name  # noqa: PLC0415 - only used here

    return matches_node_name(name)


def _label(transition: int | str) -> str:
    is_number = isinstance(transition, int) or transition.isdecimal()
    label = _LABELS.get(int(transition), "") if is_number else str(transition)
    if label not in _GOALS:
        raise EntityTypeError("a transition", f"one of {', '.join(_GOALS)}", transition)
    return label
