"""Schedule: what happens at a fixed rate in the time of a world."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable


class Schedule:
    """Function that is called at a rate, in simulated time.

    Args:
        rate_hz: The rate. The calls are on a grid that begins at 0, so they do not drift.
        call: The function.
    """

    def __init__(self, rate_hz: float, call: Callable[[], None]) -> None:
        self._period_ns = 1e9 / rate_hz
        self._call = call
        self._next_ns = 0.0

    def run(self, now_ns: int) -> None:
        """Call the function if it is time."""
        if now_ns + 1 < self._next_ns:
            return
        self._next_ns = (now_ns // self._period_ns + 1) * self._period_ns
        self._call()

    def reset(self) -> None:
        """Begin again: the time starts at 0."""
        self._next_ns = 0.0
