"""Actions that emit events and register event handlers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.launch.action import Action
from zbot.launch.event import Shutdown as ShutdownEvent
from zbot.launch.event_handler import OnProcessExit
from zbot.launch.substitution import normalize, perform

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.launch.context import LaunchContext
    from zbot.launch.entity import LaunchDescriptionEntity
    from zbot.launch.event import Event
    from zbot.launch.event_handler import BaseEventHandler
    from zbot.launch.substitution import SomeSubstitutionsType


class EmitEvent(Action):
    """Emit an event."""

    def __init__(self, *, event: Event, **options: Any) -> None:
        super().__init__(**options)
        self.event = event

    def execute(self, context: LaunchContext) -> None:
        """Put the event at the end of the queue."""
        context.emit_event_sync(self.event)

    def describe(self) -> str:
        """Return a text with the name of the event."""
        return f"Emitting event: {self.event.name}"


class RegisterEventHandler(Action):
    """Register an event handler."""

    def __init__(self, event_handler: BaseEventHandler, **options: Any) -> None:
        super().__init__(**options)
        self.event_handler = event_handler

    def execute(self, context: LaunchContext) -> None:
        """Register the handler."""
        context.register_event_handler(self.event_handler)

    def describe(self) -> str:
        """Return a text with the description of the handler."""
        return f"RegisterEventHandler('{self.event_handler.describe()}')"

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Sequence[LaunchDescriptionEntity]]]:
        """Return the entities that the handler visits."""
        entities = getattr(self.event_handler, "entities", None)
        if isinstance(entities, Action):
            entities = [entities]
        if not entities or callable(entities):
            return []
        return [(f"{self.event_handler.describe()}", list(entities))]


class UnregisterEventHandler(Action):
    """Remove an event handler."""

    def __init__(self, event_handler: BaseEventHandler, **options: Any) -> None:
        super().__init__(**options)
        self.event_handler = event_handler

    def execute(self, context: LaunchContext) -> None:
        """Remove the handler."""
        context.unregister_event_handler(self.event_handler)


class Shutdown(Action):
    """End the launch and all its processes.

    Args:
        reason: The reason that the log shows.
    """

    def __init__(
        self, *, reason: SomeSubstitutionsType = "reason not given", **options: Any
    ) -> None:
        super().__init__(**options)
        self.reason = normalize(reason)

    def execute(self, context: LaunchContext) -> None:
        """Emit the shutdown event."""
        context.emit_event_sync(ShutdownEvent(reason=perform(context, self.reason)))

    def describe(self) -> str:
        """Return the name of the action."""
        return "Shutdown()"


def shutdown_on_process_exit(process_action: Action) -> RegisterEventHandler:
    """Return an action that ends the launch when the process of `process_action` ends."""
    end = EmitEvent(event=ShutdownEvent(reason="process exited"))
    return RegisterEventHandler(OnProcessExit(target_action=process_action, on_exit=end))
