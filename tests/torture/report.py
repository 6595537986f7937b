"""Report of a run: what happened, what broke a promise, and the figures."""

from __future__ import annotations

import contextlib
import math
import shutil
import statistics
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path

    from tests.torture.stall import StallMeter

_MOST_PRINTED = 100


class Report:
    """Report of a run. It prints each line at once."""

    def __init__(self) -> None:
        self._begin = time.monotonic()
        self.violations: list[str] = []
        self.counts: dict[str, int] = {}
        self._is_interrupted = False

    def note(self, text: str) -> None:
        """Print a line with the time since the begin."""
        print(f"{time.monotonic() - self._begin:8.2f} s  {text}", flush=True)

    def count(self, what: str) -> None:
        """Count something for the figures."""
        self.counts[what] = self.counts.get(what, 0) + 1

    def violation(self, text: str) -> None:
        """Note that a promise was broken."""
        self.violations.append(text)
        if len(self.violations) <= _MOST_PRINTED:
            self.note(f"BROKEN: {text}")

    def limit(self, title: str, value: float, most: float, unit: str) -> None:
        """Note that a promise was broken if a value is larger than its limit."""
        if value > most:
            self.violation(f"{title}: {value:.0f} {unit}, but at most {most:.0f}")

    @contextlib.contextmanager
    def until_interrupted(self) -> Iterator[None]:
        """End the block at Ctrl-C, and go on with the report of what has been until then."""
        try:
            yield
        except KeyboardInterrupt:
            self._is_interrupted = True
            self.note("interrupted")

    def end(self, again: str, folder: Path, stall: StallMeter) -> int:
        """Print the result, and return the exit code.

        Args:
            again: The command that runs the same again.
            folder: The outputs of the run. If no promise was broken, it is removed.
            stall: The meter of the run.
        """
        self.note(f"the machine was {stall.mean_slowdown():.2f} times as slow as when it is idle")
        figures = ", ".join(f"{count} {what}" for what, count in sorted(self.counts.items()))
        self.note(f"counts: {figures}")
        self.note(f"{len(self.violations)} promises broken")
        for text in self.violations[:_MOST_PRINTED]:
            print(f"  {text}")
        print(f"again: {again}", flush=True)
        if self.violations:
            print(f"outputs: {folder}", flush=True)
            return 1
        shutil.rmtree(folder, ignore_errors=True)
        return 130 if self._is_interrupted else 0


def times(values_s: Sequence[float]) -> str:
    """Return median, 95th percentile and maximum of some times as text."""
    if not values_s:
        return "none"
    high, longest = percentile(values_s, 0.95), max(values_s)
    median = statistics.median(values_s)
    return f"median {median:.2f} s, 95 % {high:.2f} s, longest {longest:.2f} s ({len(values_s)})"


def percentile(values: Sequence[float], share: float) -> float:
    """Return the value that is larger than a share of the others. Without values, return inf."""
    return sorted(values)[int(share * (len(values) - 1))] if values else math.inf
