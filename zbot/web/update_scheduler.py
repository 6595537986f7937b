"""Which of a page's updates are due when its browser asks."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

# A browser asks at its display's pace, a bit early or late.
_EARLY_S = 0.003


class Pace:
    """Runs functions when they are asked for, but none more often than it wants to be.

    Args:
        on_fault: Told of a function that raised, which then is not run any more.
    """

    def __init__(self, on_fault: Callable[[Exception], None]) -> None:
        self._on_fault = on_fault
        self._updates: dict[object, tuple[Callable[[], None], float]] = {}
        self._ran: dict[object, float] = {}

    def add(self, update: Callable[[], None], max_hz: float) -> Callable[[], None]:
        """Run a function from now on; return a function that ends this."""
        key = object()
        self._updates[key] = (update, 1 / max_hz - _EARLY_S)

        def undo() -> None:
            self._updates.pop(key, None)
            self._ran.pop(key, None)

        return undo

    def run(self, now_s: float) -> None:
        """Run what is due.

        Args:
            now_s: Seconds of a clock that does not run backwards.
        """
        for key, (update, period_s) in list(self._updates.items()):
            if now_s - self._ran.get(key, -period_s) < period_s or key not in self._updates:
                continue
            self._ran[key] = now_s
            try:
                update()
            except Exception as error:  # noqa: BLE001 - the page tells it, the others go on
                self._updates.pop(key, None)
                self._on_fault(error)
