"""Weak set that several threads can use."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterator

T = TypeVar("T")


class WeakSet(weakref.WeakSet[T]):
    """Variant of Python's `WeakSet` that any thread may change during an iteration.

    An iteration returns the members that the set had when the iteration began.
    """

    def __iter__(self) -> Iterator[T]:
        references = list(self.data)  # type: ignore[attr-defined] # one atomic step
        return iter([item for reference in references if (item := reference()) is not None])
