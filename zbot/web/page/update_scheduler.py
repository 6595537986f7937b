"""Scheduler of a page's updates. Updates run when the browser asks for changes."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

# The browser asks for changes only when it refreshes the screen, so an update cannot start at an
# exact time. It may start this many seconds early, so that it does not wait for the next refresh.
_EARLY_S = 0.003


class UpdateScheduler:
    """Scheduler that limits how often each function runs.

    Args:
        on_fault: Called with the exception of a function. The function does not run again.
    """

    def __init__(self, on_fault: Callable[[Exception], None]) -> None:
        self._on_fault = on_fault
        self._updates: dict[object, tuple[Callable[[], None], float]] = {}
        self._ran: dict[object, float] = {}

    def add(self, update: Callable[[], None], max_hz: float) -> Callable[[], None]:
        """Add a function. Return a function that removes it."""
        key = object()
        self._updates[key] = (update, 1 / max_hz - _EARLY_S)

        def undo() -> None:
            self._updates.pop(key, None)
            self._ran.pop(key, None)

        return undo

    def run(self, now_s: float) -> None:
        """Run the functions that are due.

        Args:
            now_s: Seconds of a clock that does not run backwards.
        """
        for key, (update, period_s) in list(self._updates.items()):
            if now_s - self._ran.get(key, -period_s) < period_s or key not in self._updates:
                continue
            self._ran[key] = now_s
            try:
                update()
            except Exception as error:  # noqa: BLE001 - the page shows it
                self._updates.pop(key, None)
                self._on_fault(error)
