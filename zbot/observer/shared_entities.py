"""Entities that several users share, and a timer that publishes with a shared publisher."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable

    from typing_extensions import Self

    from zbot.executor.timer import Timer
    from zbot.node.node import Node
    from zbot.node.publisher import Publisher

T = TypeVar("T")


class EntityReference(Generic[T]):
    """Counted reference to a shared entity.

    Attributes:
        entity: The entity, e.g. a publisher or a client.
    """

    def __init__(self, entity: T, release: Callable[[], None]) -> None:
        self.entity = entity
        self._release: Callable[[], None] | None = release

    def release(self) -> None:
        """Release the reference. The release of the last reference destroys the entity.

        A second call does nothing.
        """
        release, self._release = self._release, None
        if release is not None:
            release()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()


class _CountedEntity:
    def __init__(self, entity: Any, destroy: Callable[[], object]) -> None:
        self.entity, self.destroy = entity, destroy
        self.references = 0


class SharedEntities:
    """Entities by key, with reference counts. Any thread may call any method."""

    def __init__(self) -> None:
        self._shared: dict[Hashable, _CountedEntity] = {}
        self._lock = threading.RLock()

    def __len__(self) -> int:
        return len(self._shared)

    def get(
        self, key: Hashable, make: Callable[[], T], destroy: Callable[[T], object]
    ) -> EntityReference[T]:
        """Return a reference to the entity with a key. Create the entity if it does not exist."""
        with self._lock:
            shared = self._shared.get(key)
            if shared is None:
                entity = make()
                shared = self._shared[key] = _CountedEntity(entity, lambda: destroy(entity))
            shared.references += 1
        return EntityReference(shared.entity, lambda: self._release(key, shared))

    def _release(self, key: Hashable, shared: _CountedEntity) -> None:
        with self._lock:
            shared.references -= 1
            if shared.references:
                return
            del self._shared[key]
            shared.destroy()


class RepeatedPublishing:
    """Timer that publishes at a rate, in the node's thread, until `release`.

    Args:
        node: The node of the timer.
        reference: A reference to the publisher, which `release` releases too.
        make: Function that returns the message. It is called for each message, so that
            each message has a new stamp.
        rate_hz: Messages a second.
    """

    def __init__(
        self,
        node: Node,
        reference: EntityReference[Publisher[Any]],
        make: Callable[[], Any],
        rate_hz: float,
    ) -> None:
        self._node, self._reference = node, reference
        self._make, self._rate_hz = make, rate_hz
        self._timer: Timer | None = node.create_timer(1 / rate_hz, self._publish)
        self._publish()

    def change(self, make: Callable[[], Any], rate_hz: float) -> None:
        """Change the message or the rate."""
        self._make = make
        if rate_hz != self._rate_hz and self._timer is not None:
            self._rate_hz = rate_hz
            self._node.destroy_timer(self._timer)
            self._timer = self._node.create_timer(1 / rate_hz, self._publish)

    def _publish(self) -> None:
        if self._reference.entity.is_open:
            self._reference.entity.publish(self._make())

    def release(self) -> None:
        """Stop publishing. A second call does nothing."""
        timer, self._timer = self._timer, None
        if timer is not None:
            self._node.destroy_timer(timer)
            self._reference.release()
