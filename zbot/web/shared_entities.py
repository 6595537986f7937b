"""Things that several browsers share, and that end when nobody needs them any more."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable

    from typing_extensions import Self

T = TypeVar("T")


class Lease(Generic[T]):
    """One holder's part in a shared thing.

    Attributes:
        entity: The thing: a publisher, a client, ...
    """

    def __init__(self, entity: T, release: Callable[[], None]) -> None:
        self.entity = entity
        self._release: Callable[[], None] | None = release

    def release(self) -> None:
        """Need it no more; the last holder's release destroys it. May be called twice."""
        release, self._release = self._release, None
        if release is not None:
            release()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()


class _Shared:
    def __init__(self, entity: Any, destroy: Callable[[], object]) -> None:
        self.entity, self.destroy = entity, destroy
        self.holders = 0


class Leases:
    """Makes each thing once and counts who holds it. All methods may be called from any thread."""

    def __init__(self) -> None:
        self._shared: dict[Hashable, _Shared] = {}
        self._lock = threading.RLock()

    def __len__(self) -> int:
        return len(self._shared)

    def get(self, key: Hashable, make: Callable[[], T], destroy: Callable[[T], object]) -> Lease[T]:
        """Return a lease of the thing under a key, made if nobody holds it yet."""
        with self._lock:
            shared = self._shared.get(key)
            if shared is None:
                entity = make()
                shared = self._shared[key] = _Shared(entity, lambda: destroy(entity))
            shared.holders += 1
        return Lease(shared.entity, lambda: self._release(key, shared))

    def _release(self, key: Hashable, shared: _Shared) -> None:
        with self._lock:
            shared.holders -= 1
            if shared.holders:
                return
            del self._shared[key]
            shared.destroy()
