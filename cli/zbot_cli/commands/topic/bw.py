"""Bandwidths that `zbot topic bw` prints: bytes a second, and the sizes of messages in bytes."""

from __future__ import annotations

import sys
from collections import deque
from typing import TYPE_CHECKING, Any

from zbot_cli.commands.topic.measurement import TIME_RESET

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot_cli.commands.topic.measurement import Meter


class _SizeMeter:
    def __init__(self, window: int, now_ns: Callable[[], int]) -> None:
        self._times: deque[int] = deque(maxlen=max(window, 2))
        self._sizes: deque[int] = deque(maxlen=max(window, 2))
        self._now_ns = now_ns

    def add(self, message: Any) -> None:
        now = self._now_ns()
        if now == 0:  # simulated time has not started
            return
        if self._times and now < self._times[-1]:  # the simulation was restarted
            print(TIME_RESET, file=sys.stderr, flush=True)
            self._times.clear()
            self._sizes.clear()
        self._times.append(now)
        self._sizes.append(len(message))

    def figures(self) -> dict[str, float] | None:
        times, sizes = list(self._times), list(self._sizes)  # Zenoh's thread may add items
        if min(len(times), len(sizes)) < 2:
            return None
        elapsed = (self._now_ns() - times[0]) / 1e9
        if elapsed <= 0:  # simulated time is paused
            return None
        return {
            "bytes_per_second": sum(sizes) / elapsed,
            "messages": len(sizes),
            "mean": sum(sizes) / len(sizes),
            "min": min(sizes),
            "max": max(sizes),
        }


class Bandwidths:
    """Measurement of the number of bytes that arrive."""

    prints_subscription = True
    decodes = compares_stamps = False
    columns: tuple[str, ...] = ("topic", "rate", "messages", "mean", "min", "max")

    def __init__(self, window: int) -> None:
        self._window = window

    def meter(self, now_ns: Callable[[], int]) -> Meter:
        """Return a meter for one topic."""
        return _SizeMeter(self._window, now_ns)

    def text(self, figures: dict[str, float]) -> str:
        """Return the two lines that `ros2 topic` prints."""
        rate, mean, low, high = self._in_unit(figures)
        return (
            f"{rate}/s from {figures['messages']:.0f} messages\n"
            f"\tMessage size mean: {mean} min: {low} max: {high}"
        )

    def cells(self, figures: dict[str, float]) -> list[str]:
        """Return a row of the table, without the name of the topic."""
        rate, *sizes = self._in_unit(figures)
        return [f"{rate}/s", f"{figures['messages']:.0f}", *sizes]

    @staticmethod
    def _in_unit(figures: dict[str, float]) -> list[str]:
        values = [figures[key] for key in ("bytes_per_second", "mean", "min", "max")]
        if values[0] < 1000:
            return [f"{value:.0f} B" for value in values]
        scale, unit = (1e3, "KB") if values[0] < 1e6 else (1e6, "MB")
        return [f"{value / scale:.2f} {unit}" for value in values]
