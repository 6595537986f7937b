"""Rates that `zbot topic hz` prints: messages a second, from the times at which they arrive."""

from __future__ import annotations

import math
import sys
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot_cli.commands.topic.measurement import TIME_RESET, statistics

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot_cli.commands.topic.measurement import Meter


class _IntervalMeter:
    def __init__(
        self, window: int, accepts: Callable[[Any], bool] | None, now_ns: Callable[[], int]
    ) -> None:
        self._intervals: deque[float] = deque(maxlen=max(window, 1))
        self._accepts = accepts
        self._now_ns = now_ns
        self._last: int | None = None
        self._changed = False

    def add(self, message: Any) -> None:
        if self._accepts is not None and not self._accepts(message):
            return
        now = self._now_ns()
        if now == 0:  # simulated time has not started
            return
        if self._last is not None and now >= self._last:
            self._intervals.append((now - self._last) / 1e9)
            self._changed = True
        elif self._last is not None:  # the simulation was restarted
            print(TIME_RESET, file=sys.stderr, flush=True)
            self._intervals.clear()
            self._changed = False
        self._last = now

    def figures(self) -> dict[str, float] | None:
        intervals = list(self._intervals)  # Zenoh's thread may add an interval at any time
        if not (self._changed and intervals):
            return None
        self._changed = False
        mean, low, high, deviation = statistics(intervals)
        return {
            "rate": 1 / mean if mean > 0 else math.inf,
            "min": low,
            "max": high,
            "std_dev": deviation,
            "window": len(intervals),
        }


class Rates:
    """Measurement of the rate at which messages arrive."""

    prints_subscription = compares_stamps = False
    columns: tuple[str, ...] = ("topic", "rate", "min_delta", "max_delta", "std_dev", "window")

    def __init__(self, window: int, filter_expression: str | None = None) -> None:
        self._window = window
        self._filter = filter_expression
        self.decodes = filter_expression is not None

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        accepts = None
        if self._filter is not None:
            from zbot_cli.input.filter import Filter  # noqa: PLC0415 - seldom used

            accepts = Filter(self._filter).accepts
        return _IntervalMeter(self._window, accepts, now_ns)

    def text(self, figures: dict[str, float]) -> str:
        """Return the two lines that `ros2 topic` prints."""
        return (
            f"average rate: {figures['rate']:.3f}\n"
            f"\tmin: {figures['min']:.3f}s max: {figures['max']:.3f}s "
            f"std dev: {figures['std_dev']:.5f}s window: {figures['window']}"
        )

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table, without the name of the topic."""
        return [
            f"{figures['rate']:.3f}",
            f"{figures['min']:.3f}",
            f"{figures['max']:.3f}",
            f"{figures['std_dev']:.5f}",
            f"{figures['window']}",
        ]
