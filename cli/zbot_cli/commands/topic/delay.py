"""Delays that `zbot topic delay` prints: seconds from a message's stamp to its arrival."""

from __future__ import annotations

import sys
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot_cli.commands.topic.measurement import statistics
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot_cli.commands.topic.measurement import Meter


# September 2001. A time before it is 0, or the seconds since a board was switched on.
_OLDEST_TIME_S = 10**9
_NO_CLOCK = (
    "the stamps of these messages are no times of day, so the delays mean nothing: "
    "the sender, e.g. a board, has no clock"
)


class _DelayMeter:
    def __init__(self, window: int, now_ns: Callable[[], int]) -> None:
        self._delays: deque[float] = deque(maxlen=max(window, 1))
        self._now_ns = now_ns
        self._started = self._changed = self._has_warned = False

    def add(self, message: Any) -> None:
        header = getattr(message, "header", None)
        if header is None:
            raise CommandError("msg does not have header")
        now_ns = self._now_ns()
        age_ns = now_ns - (header.stamp.sec * 10**9 + header.stamp.nanosec)
        if header.stamp.sec < _OLDEST_TIME_S <= now_ns // 10**9 and not self._has_warned:
            print(_NO_CLOCK, file=sys.stderr, flush=True)
            self._has_warned = True
        if self._started:  # ROS 2 does not count the first message either
            self._delays.append(age_ns / 1e9)
            self._changed = True
        self._started = True

    def figures(self) -> dict[str, float] | None:
        if not self._changed:
            return None
        self._changed = False
        mean, low, high, deviation = statistics(self._delays)
        return {
            "delay": mean,
            "min": low,
            "max": high,
            "std_dev": deviation,
            "window": len(self._delays),
        }


class Delays:
    """Measurement of the age of messages when they arrive."""

    prints_subscription = False
    decodes = compares_stamps = True
    columns: tuple[str, ...] = ("topic", "delay", "min", "max", "std_dev", "window")

    def __init__(self, window: int) -> None:
        self._window = window

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        return _DelayMeter(self._window, now_ns)

    def text(self, figures: dict[str, float]) -> str:
        """Return the two lines that `ros2 topic` prints."""
        return (
            f"average delay: {figures['delay']:.3f}\n"
            f"\tmin: {figures['min']:.3f}s max: {figures['max']:.3f}s "
            f"std dev: {figures['std_dev']:.5f}s window: {figures['window']}"
        )

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table, without the name of the topic."""
        return [f"{figures[key]:.5f}" for key in ("delay", "min", "max", "std_dev")] + [
            f"{figures['window']}"
        ]
