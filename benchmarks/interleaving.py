"""Rows of a table, and their values for each contestant.

Contestants run in turns, so that other work of the machine affects all of them. A run that other
programs disturb is repeated. The value of a cell is the median over the turns.
"""

from __future__ import annotations

import math
import statistics
import sys
import time
from collections import defaultdict
from typing import TYPE_CHECKING, NamedTuple

from benchmarks.contestant import RCLPY, Contestant, ProgramError
from benchmarks.other_load import OtherLoad, wait_for_quiet

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

# The router of a domain, which the programs start, uses 0.1 to 0.2 s.
_OTHER_CORES = 0.4

Sample = dict[str, float]  #: what one run measured, e.g. {"rate": 5e4, "lost": 0}


class Row(NamedTuple):
    """One line of a table, which each contestant can run."""

    label: str
    run: Callable[[Contestant], Sample]


class Disturbances:
    """How often other programs disturbed a run, and the time that is left for repetitions."""

    repeated = 0
    kept = 0
    left_s = 90.0


def quiet_run(row: Row, contestant: Contestant) -> Sample:
    """Run a row, again if other programs used much of the machine and there is time to wait."""
    while True:
        begun, load = time.monotonic(), OtherLoad()
        sample = row.run(contestant)
        if load.cores() < _OTHER_CORES:
            return sample
        if Disturbances.left_s <= 0:
            Disturbances.kept += 1
            return sample
        Disturbances.repeated += 1
        wait_for_quiet(_OTHER_CORES, Disturbances.left_s)
        Disturbances.left_s -= time.monotonic() - begun


class Cells:
    """Samples of one row."""

    def __init__(self) -> None:
        self._samples: dict[str, list[Sample]] = defaultdict(list)

    def measure(self, row: Row, contestants: Sequence[Contestant], rounds: int) -> None:
        """Run a row in turns and keep the samples."""
        for _ in range(rounds):
            for contestant in contestants:
                try:
                    self._samples[contestant.name].append(quiet_run(row, contestant))
                except ProgramError as exc:
                    if contestant not in RCLPY:  # its interpreter sometimes ends without a message
                        raise
                    print(exc, file=sys.stderr)

    def names(self) -> list[str]:
        return list(self._samples)

    def median(self, contestant: Contestant | str, metric: str) -> float:
        """Return the median of a contestant, or NaN if none of its runs had a result."""
        name = contestant if isinstance(contestant, str) else contestant.name
        values = [sample[metric] for sample in self._samples[name]]
        return statistics.median(values) if values else math.nan

    def total(self, contestant: Contestant, metric: str) -> float:
        return sum(sample[metric] for sample in self._samples[contestant.name])

    def best(self, ways: Iterable[Contestant], metric: str, *, highest: bool = False) -> Contestant:
        """Return the way with the best median."""
        key = lambda way: self.median(way, metric)  # noqa: E731 - used once in each line
        return max(ways, key=key) if highest else min(ways, key=key)


def measured(row: Row, contestants: Sequence[Contestant], rounds: int) -> Cells:
    """Return the samples of a row after some rounds."""
    cells = Cells()
    cells.measure(row, contestants, rounds)
    return cells


def percentile(values: Sequence[float], share: float) -> float:
    """Return the value below which a share of the values is, or NaN if there is none."""
    return sorted(values)[min(int(len(values) * share), len(values) - 1)] if values else math.nan
