"""Pace of a simulation: how fast its time runs beside the real time."""

from __future__ import annotations

import time

#: If the simulation is later than this, it does not try to catch up.
_MOST_LATE_S = 0.2
_SAY_PERIOD_S = 5.0


class Pace:
    """Pace of the time in a world.

    Args:
        factor: Simulated seconds in a real second. None means as fast as possible.
    """

    def __init__(self, factor: float | None) -> None:
        self.factor = factor
        self._due_s = self._said_s = time.monotonic()
        self._steps_since = 0.0

    def is_due(self, step_s: float) -> bool:
        """Return whether the next step shall be done now. Then its time is used up."""
        if self.factor is None:
            return True
        now_s = time.monotonic()
        if now_s < self._due_s:
            return False
        self._due_s = max(self._due_s, now_s - _MOST_LATE_S) + step_s / self.factor
        return True

    def count(self, step_s: float) -> float | None:
        """Count a step. Every few seconds, return the simulated seconds in a real second."""
        self._steps_since += step_s
        passed_s = time.monotonic() - self._said_s
        if passed_s < _SAY_PERIOD_S:
            return None
        reached = self._steps_since / passed_s
        self.restart()
        return reached

    def restart(self) -> None:
        """Begin to measure, after a pause."""
        self._said_s = time.monotonic()
        self._due_s = max(self._due_s, self._said_s)
        self._steps_since = 0.0
