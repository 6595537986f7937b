"""Base class of actions. An action is one thing that a launch does, e.g. start a node."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.entity import LaunchDescriptionEntity, calling_line
from zbot.launch.errors import EntityTypeError, unknown_argument_error
from zbot.launch.event import ExecutionComplete

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Sequence

    from zbot.launch.condition import Condition
    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import Origin
    from zbot.launch.frontend.entity import Entity
    from zbot.launch.frontend.parser import Parser


class Action(LaunchDescriptionEntity):
    """An action of a launch, with an optional condition.

    Args:
        condition: The action runs only if the condition is true. None means that it always runs.
        unknown: Arguments that neither the action nor its base classes have.

    Raises:
        WrongArgumentsError: There is an unknown argument.
        EntityTypeError: `condition` is not a condition.
    """

    def __init__(self, *, condition: Condition | None = None, **unknown: object) -> None:
        for name in unknown:
            raise unknown_argument_error(type(self), name)
        if condition is not None and not hasattr(condition, "evaluate"):
            raise EntityTypeError("condition", "IfCondition(...)", condition)
        self.condition = condition
        self.origin: Origin | None = calling_line()

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:  # noqa: ARG003
        """Return the class and the constructor options for a tag in XML or YAML.

        A subclass calls this method of its base class and adds its own options.
        """
        return cls, {}

    def describe(self) -> str:
        """Return a description in one line."""
        return f"{type(self).__name__}()"

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Execute the action if its condition is true. Return the entities to visit next."""
        if self.condition is not None and not self.condition.evaluate(context):
            return None
        following = self.execute(context)
        self._announce_completion(context)
        return following

    def _announce_completion(self, context: LaunchContext) -> None:
        event = ExecutionComplete(action=self)
        if not context.would_handle_event(event):
            return
        future = self.get_asyncio_future()
        if future is None or future.done():
            context.emit_event_sync(event)
        else:
            future.add_done_callback(lambda _: context.emit_event_sync(event))

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Perform the action and return the entities to visit next."""

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return a future that is done when the action has ended.

        Return None if the action has already ended when `execute` returns.
        """
        return None
