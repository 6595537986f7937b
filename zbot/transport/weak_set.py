"""A set that keeps nothing alive, and that several threads use."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Iterator

T = TypeVar("T")


class WeakSet(weakref.WeakSet[T]):
    """Python's, but one that may change while it is iterated, in the same thread or another.

    Who iterates sees the members of the moment in which it began.
    """

    def __iter__(self) -> Iterator[T]:
        references = list(self.data)  # type: ignore[attr-defined] # in one step: no Python runs
        return iter([item for one in references if (item := one()) is not None])
