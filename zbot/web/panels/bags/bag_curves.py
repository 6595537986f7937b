"""Curves of a bag that the user chooses one after the other. Each is read once."""

from __future__ import annotations

import asyncio
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Sequence


class BagCurves:
    """Curves by name. Reading one takes as long as reading the whole bag.

    Args:
        read: Reads a curve in a thread.
    """

    def __init__(self, read: Callable[[str], Coroutine[Any, Any, dict[str, Any]]]) -> None:
        self._read = read
        self._known: dict[str, asyncio.Task[dict[str, Any]]] = {}

    async def choose(self, names: Sequence[str]) -> list[dict[str, Any]] | None:
        """Return curves. Return None if others are chosen meanwhile: their answer is the next.

        Curves that are not chosen are forgotten.
        """
        own = {
            name: self._known.get(name) or asyncio.create_task(self._read(name)) for name in names
        }
        self._known = own
        found = await asyncio.gather(*own.values(), return_exceptions=True)
        if self._known is not own:
            return None
        curves: list[dict[str, Any]] = []
        for name, curve in zip(names, found, strict=True):
            if isinstance(curve, BaseException):
                del own[name]  # the next choice reads it again
                raise curve
            curves.append(curve)
        return curves
