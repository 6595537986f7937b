"""Publishers and clients that browsers share. Each exists until its last reference is released."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable

    from typing_extensions import Self

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
