"""Event handlers, which visit entities or call functions when they get a matching event."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias, cast

from zbot.launch.entity import LaunchDescriptionEntity
from zbot.launch.errors import EntityTypeError
from zbot.launch.event import ExecutionComplete, IncludeLaunchDescriptionEvent, Shutdown
from zbot.launch.process_event import ProcessExited, ProcessIO, ProcessStarted

if TYPE_CHECKING:
    from zbot.launch.action import Action
    from zbot.launch.context import LaunchContext
    from zbot.launch.event import Event

Entities: TypeAlias = LaunchDescriptionEntity | Iterable[LaunchDescriptionEntity] | None
#: The types in `Entities`, for `isinstance`.
Entities_types_tuple = (LaunchDescriptionEntity, Iterable)
#: Entities, or a function that takes event and context and returns entities.
Reaction: TypeAlias = Entities | Callable[..., Any]


class BaseEventHandler:
    """Base class of event handlers.

    Args:
        matcher: Returns whether the handler reacts to an event.
        handle_once: Whether the handler reacts only to the first matching event.
    """

    def __init__(self, *, matcher: Callable[[Any], bool], handle_once: bool = False) -> None:
        self._matcher = matcher
        self.handle_once = handle_once

    def matches(self, event: Event) -> bool:
        """Return whether the handler reacts to an event."""
        return self._matcher(event)

    def handle(self, event: Event, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Handle the event and return the entities to visit."""
        context.extend_locals({"event": event})  # `LaunchService` removes this local afterwards
        if self.handle_once:
            context.unregister_event_handler(self)
        return []

    def describe(self) -> str:
        """Return a description in one line."""
        return f"{type(self).__name__}()"


class EventHandler(BaseEventHandler):
    """Visits entities when a matching event comes.

    Args:
        matcher: Returns whether the handler reacts to an event.
        entities: The entities, or a function that returns them.
        handle_once: Whether the handler reacts only to the first matching event.
    """

    def __init__(
        self,
        *,
        matcher: Callable[[Any], bool],
        entities: Reaction = None,
        handle_once: bool = False,
    ) -> None:
        super().__init__(matcher=matcher, handle_once=handle_once)
        self.entities = entities

    def handle(self, event: Event, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Return the entities."""
        super().handle(event, context)
        return react(self.entities, event, context)


def react(
    reaction: Reaction, event: Event, context: LaunchContext
) -> Sequence[LaunchDescriptionEntity]:
    """Return the entities of a reaction. Call the reaction if it is a function."""
    if callable(reaction):
        # A function gets the event and the context. Functions in old launch files have only one
        # argument, the event.
        code = getattr(reaction, "__code__", None)
        is_method = hasattr(reaction, "__self__")
        takes_one = code is not None and code.co_argcount - is_method == 1 and not code.co_flags & 4
        arguments = (event,) if takes_one else (event, context)
        return _listed(reaction(*arguments))
    return _listed(reaction)


def _listed(reaction: Any) -> Sequence[LaunchDescriptionEntity]:
    if reaction is None:
        return []
    if isinstance(reaction, LaunchDescriptionEntity) or not isinstance(reaction, Iterable):
        return [cast("LaunchDescriptionEntity", reaction)]
    return cast("Sequence[LaunchDescriptionEntity]", reaction)


class OnActionEventBase(EventHandler):
    """Reacts to events about one action or about every action.

    Args:
        action_matcher: The action, a function that selects actions, or None for every action.
        on_event: The reaction.
        target_event_cls: The class of the events.
        handle_once: Whether the handler reacts only to the first matching event.

    Raises:
        EntityTypeError: `action_matcher` or `on_event` has another type.
    """

    def __init__(
        self,
        *,
        action_matcher: Action | Callable[[Any], bool] | None,
        on_event: Reaction,
        target_event_cls: type[Event],
        handle_once: bool = False,
    ) -> None:
        given: object = action_matcher
        is_action = given is None or isinstance(given, LaunchDescriptionEntity)
        if not is_action and not callable(given):
            raise EntityTypeError("target_action", "an action or a function", given)
        self.target = action_matcher
        self.event_class = target_event_cls
        if not callable(on_event):
            on_event = _listed(on_event)
            for number, action in enumerate(on_event):
                if not isinstance(action, LaunchDescriptionEntity):
                    raise EntityTypeError(f"reaction {number} to an event", "an action", action)
        super().__init__(matcher=self._matches_target, entities=on_event, handle_once=handle_once)

    def _matches_target(self, event: Any) -> bool:
        if not isinstance(event, self.event_class):
            return False
        action = cast("Any", event).action
        if self.target is None or isinstance(self.target, LaunchDescriptionEntity):
            return self.target is None or self.target is action
        return bool(self.target(action))


class OnExecutionComplete(OnActionEventBase):
    """Reacts when an action is done."""

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_completion: Reaction = None,
        **options: Any,
    ) -> None:
        super().__init__(
            action_matcher=target_action,
            on_event=on_completion,
            target_event_cls=ExecutionComplete,
            **options,
        )


class OnProcessStart(OnActionEventBase):
    """Reacts when a process starts."""

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_start: Reaction = None,
        **options: Any,
    ) -> None:
        super().__init__(
            action_matcher=target_action,
            on_event=on_start,
            target_event_cls=ProcessStarted,
            **options,
        )


class OnProcessExit(OnActionEventBase):
    """Reacts when a process ends."""

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_exit: Reaction = None,
        **options: Any,
    ) -> None:
        super().__init__(
            action_matcher=target_action,
            on_event=on_exit,
            target_event_cls=ProcessExited,
            **options,
        )


class OnProcessIO(OnActionEventBase):
    """Reacts to output of a process, or to input for its stdin.

    If a reaction is a function, it gets only the event. The `text` of the event is bytes.
    """

    def __init__(
        self,
        *,
        target_action: Action | Callable[[Any], bool] | None = None,
        on_stdin: Reaction = None,
        on_stdout: Reaction = None,
        on_stderr: Reaction = None,
        **options: Any,
    ) -> None:
        self._reactions = (on_stdin, on_stdout, on_stderr)
        super().__init__(
            action_matcher=target_action,
            on_event=self._react,
            target_event_cls=ProcessIO,
            **options,
        )

    def _react(self, event: Any, context: LaunchContext) -> Any:
        reaction = self._reactions[event.fd]
        if callable(reaction):
            return reaction(event)
        return react(reaction, event, context)


class OnShutdown(EventHandler):
    """Reacts to the shutdown of the launch."""

    def __init__(self, *, on_shutdown: Reaction, **options: Any) -> None:
        super().__init__(
            matcher=lambda event: isinstance(event, Shutdown), entities=on_shutdown, **options
        )


class OnIncludeLaunchDescription(BaseEventHandler):
    """Launches the description of an `IncludeLaunchDescriptionEvent`."""

    def __init__(self, **options: Any) -> None:
        super().__init__(
            matcher=lambda event: isinstance(event, IncludeLaunchDescriptionEvent), **options
        )

    def handle(self, event: Event, context: LaunchContext) -> Sequence[LaunchDescriptionEntity]:
        """Return the description of the event."""
        super().handle(event, context)
        return [cast("IncludeLaunchDescriptionEvent", event).launch_description]
