"""How the parts of a node tell their executor that they have work."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup


class Entity(Protocol):
    """What an executor can run: a subscription, timer, service, guard condition ..."""

    callback_group: CallbackGroup

    @property
    def ready_queue(self) -> ReadyQueue | None:
        """Its node's ready queue; `None` for what belongs to an executor itself."""

    @property
    def due_ns(self) -> int | None:
        """When a timer wants to run (monotonic clock, nanoseconds); `None` for all others."""

    def take(self) -> Any | None:
        """Return one piece of work, or `None` if there is none; called by the executor's thread."""

    def execute(self, taken: Any, /) -> Any:
        """Run the user's callback for what was taken; may return a coroutine."""


class ReadyQueue:
    """One node's slot for an executor: what is posted while it has none is asked for later.

    Entities keep their work themselves, so a post carries no data and may come too often.
    """

    def __init__(self) -> None:
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        self._entities: list[Entity] = []
        self._deliver: Callable[[Entity], None] | None = None
        self._attached: Callable[[Entity], None] | None = None
        self._watchers: list[tuple[Entity, Callable[[], object]]] = []
        self.executor: object = None  #: who gets the posts now

    @property
    def entities(self) -> list[Entity]:
        """The node's entities, in order of creation."""
        return list(self._entities)

    def add(self, entity: Entity) -> None:
        """Make an entity known; it is asked for work at once."""
        with self._lock:
            self._entities.append(entity)
        self.post(entity)

    def remove(self, entity: Entity) -> None:
        """Forget an entity; nothing happens if it is unknown."""
        with self._lock:
            if entity in self._entities:
                self._entities.remove(entity)

    def __contains__(self, entity: object) -> bool:
        return entity in self._entities

    def attach(self, executor: object, deliver: Callable[[Entity], None]) -> None:
        """Send posts to an executor's function, beginning with one for every entity."""
        with self._lock:
            self.executor, self._attached = executor, deliver
            self._choose_delivery()
            entities = list(self._entities)
        for entity in entities:
            deliver(entity)

    def detach(self) -> None:
        """Keep posts from now on until the next executor comes."""
        with self._lock:
            self.executor = self._attached = None
            self._choose_delivery()

    def watch(self, entity: Entity, watcher: Callable[[], object]) -> None:
        """Call a quick function too whenever an entity may have work, also without an executor."""
        with self._lock:
            self._watchers.append((entity, watcher))
            self._choose_delivery()

    def unwatch(self, entity: Entity, watcher: Callable[[], object]) -> None:
        """Undo one `watch`; nothing happens if there was none."""
        with self._lock:
            if (entity, watcher) in self._watchers:
                self._watchers.remove((entity, watcher))
            self._choose_delivery()

    def _choose_delivery(self) -> None:
        # Decided here and not with each post: hardly anything is ever watched.
        self._deliver = self._deliver_and_tell if self._watchers else self._attached

    def _deliver_and_tell(self, entity: Entity) -> None:
        attached = self._attached
        if attached is not None:
            attached(entity)
        for watched, watcher in list(self._watchers):
            if watched is entity:
                watcher()

    def post(self, entity: Entity) -> None:
        """Say that an entity may have work; from any thread."""
        deliver = self._deliver
        if deliver is not None:
            deliver(entity)
