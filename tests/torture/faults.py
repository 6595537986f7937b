"""Plan of faults at random times. The same seed makes the same plan."""

from __future__ import annotations

import heapq
import itertools
import time
from random import Random
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping


class Fault(NamedTuple):
    """A fault of the plan."""

    at_s: float  #: after the begin
    kind: str
    victim: int  #: a random number that chooses among those who can have the fault
    size: float  #: 0 to 1: how long or how strong it is


def plan(seed: str, kinds: Mapping[str, float], seconds: float, pause_s: float) -> list[Fault]:
    """Return the faults of a run.

    Args:
        seed: Text.
        kinds: The kinds with their weights.
        seconds: The length of the run.
        pause_s: The mean pause between two faults.
    """
    random = Random(seed)
    faults, at_s = list[Fault](), 0.0
    while (at_s := at_s + random.expovariate(1 / pause_s)) < seconds:
        (kind,) = random.choices(list(kinds), list(kinds.values()))
        faults.append(Fault(at_s, kind, random.randrange(10**6), random.random()))
    return faults


class Schedule:
    """Functions that are called at their times, in one thread."""

    def __init__(self) -> None:
        self._number = itertools.count()
        self._waiting: list[tuple[float, int, Callable[[], None]]] = []

    def add(self, delay_s: float, function: Callable[[], None]) -> None:
        """Call a function after a delay."""
        entry = (time.monotonic() + delay_s, next(self._number), function)
        heapq.heappush(self._waiting, entry)

    def run_due(self) -> None:
        """Call the functions whose time has come."""
        while self._waiting and self._waiting[0][0] <= time.monotonic():
            heapq.heappop(self._waiting)[2]()

    def finish(self) -> None:
        """Wait for the times of all functions, and call them."""
        while self._waiting:
            time.sleep(max(0.0, self._waiting[0][0] - time.monotonic()))
            self.run_due()

    def __bool__(self) -> bool:
        return bool(self._waiting)
