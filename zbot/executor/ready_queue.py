"""Ready queue: a node's entities use it to tell their executor that they may have work."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.executor.callback_group import CallbackGroup


class Entity(Protocol):
    """A subscription, timer, service, guard condition ... that an executor can run."""

    callback_group: CallbackGroup

    @property
    def ready_queue(self) -> ReadyQueue | None:
        """The ready queue of the entity's node, or `None` for an entity of the executor itself."""

    @property
    def due_ns(self) -> int | None:
        """When a timer is due (monotonic clock, nanoseconds). `None` if this is not a timer."""

    def take(self) -> Any | None:
        """Return one piece of work, or `None`. The executor's thread calls this."""

    def execute(self, taken: Any, /) -> Any:
        """Run the user's callback with the object from `take`. This may return a coroutine."""


class ReadyQueue:
    """Gives posts to a node's executor. A post says that an entity of the node may have work.

    If the node has no executor, a post is lost. When an executor is attached, every entity is
    posted once. Entities keep their work themselves, so a post contains no data, and extra posts do
    no harm.
    """

    def __init__(self) -> None:
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._entities: list[Entity] = []
        self._deliver: Callable[[Entity], None] | None = None
        self._attached: Callable[[Entity], None] | None = None
        self._watchers: list[tuple[Entity, Callable[[], object]]] = []
        self.executor: object = None  #: the executor that gets the posts now
        self.was_attached = False  #: whether an executor has ever had the node

    @property
    def entities(self) -> list[Entity]:
        """The node's entities, in order of creation."""
        return list(self._entities)

    def add(self, entity: Entity) -> None:
        """Add an entity and post it once."""
        with self._lock:
            self._entities.append(entity)
        self.post(entity)

    def remove(self, entity: Entity) -> None:
        """Remove an entity. Do nothing if the entity is unknown."""
        with self._lock:
            if entity in self._entities:
                self._entities.remove(entity)

    def attach(self, executor: object, deliver: Callable[[Entity], None]) -> None:
        """Send all posts to an executor's function, and post every entity once."""
        with self._lock:
            self.executor, self._attached, self.was_attached = executor, deliver, True
            self._choose_delivery()
            entities = list(self._entities)
        for entity in entities:
            deliver(entity)

    def detach(self) -> None:
        """Send no posts until the next executor is attached."""
        with self._lock:
            self.executor = self._attached = None
            self._choose_delivery()

    def watch(self, entity: Entity, watcher: Callable[[], object]) -> None:
        """Call a quick function at each post of an entity, also without an executor."""
        with self._lock:
            self._watchers.append((entity, watcher))
            self._choose_delivery()

    def unwatch(self, entity: Entity, watcher: Callable[[], object]) -> None:
        """Undo one `watch`. Do nothing if there was no `watch`."""
        with self._lock:
            if (entity, watcher) in self._watchers:
                self._watchers.remove((entity, watcher))
            self._choose_delivery()

    def _choose_delivery(self) -> None:
        # The function is chosen here, so that a post needs no check for watchers, which are rare.
        self._deliver = self._deliver_and_notify if self._watchers else self._attached

    def _deliver_and_notify(self, entity: Entity) -> None:
        attached = self._attached
        if attached is not None:
            attached(entity)
        for watched, watcher in list(self._watchers):
            if watched is entity:
                watcher()

    def post(self, entity: Entity) -> None:
        """Tell the executor that an entity may have work. Any thread may call this."""
        deliver = self._deliver
        if deliver is not None:
            deliver(entity)
