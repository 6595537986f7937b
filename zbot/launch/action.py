"""Actions: what a launch file has done."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.entity import LaunchDescriptionEntity, calling_line
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
    """Something to do, perhaps under a condition.

    Args:
        condition: When to do it; always if left out.
    """

    def __init__(self, *, condition: Condition | None = None) -> None:
        self.condition = condition
        self.origin: Origin | None = calling_line()

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:  # noqa: ARG003
        """Return the class and the options that a tag in XML or YAML stands for.

        Classes of extensions call this of the class that they extend, and add options of their own.
        """
        return cls, {}

    def describe(self) -> str:
        """Return one line about it."""
        return f"{type(self).__name__}()"

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Do it if the condition holds."""
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
        """Do it; return what is to be done next."""

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return a future that is done when the action is; None if it is at once."""
        return None
