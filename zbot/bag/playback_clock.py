"""Clock of a playback. It has a rate, can stand still, and can be set."""

from __future__ import annotations

import math
import threading
import time

from zbot.time import S_TO_NS

# A player that runs asks for the time twice a second. After a longer gap, it was suspended.
_SUSPENDED_S = 2.0


class PlaybackClock:
    """Clock that converts the time of this machine to the time of a recording.

    It stands still while the program is suspended, e.g. by Ctrl-Z. Otherwise, a player would
    publish all messages of that time at once. Any thread may call its methods.

    Args:
        start_ns: First time, in nanoseconds since the epoch.
        rate: Seconds of the recording that pass in one second.
        is_paused: Whether the clock stands still at first.
    """

    def __init__(self, start_ns: int, rate: float, *, is_paused: bool) -> None:
        self._lock = threading.Lock()
        self._rate = rate
        self._is_paused = is_paused
        self._anchor_ns = start_ns
        self._set_at_s = self._asked_at_s = time.perf_counter()

    @property
    def rate(self) -> float:
        """Seconds of the recording that pass in one second."""
        return self._rate

    @property
    def is_paused(self) -> bool:
        """Whether the clock stands still."""
        return self._is_paused

    def now_ns(self) -> int:
        """Return the present time of the recording, in nanoseconds since the epoch."""
        with self._lock:
            return self._now_ns()

    def seconds_until(self, time_ns: int) -> float:
        """Return the seconds until a time of the recording, or infinity during a pause."""
        with self._lock:
            if self._is_paused:
                return math.inf
            return (time_ns - self._anchor_ns) / S_TO_NS / self._rate - self._passed_s()

    def set(self, time_ns: int) -> None:
        """Continue from another time."""
        with self._lock:
            self._begin_at(time_ns)

    def set_rate(self, rate: float) -> None:
        """Continue with another rate."""
        with self._lock:
            self._settle()
            self._rate = rate

    def pause(self) -> None:
        """Stand still."""
        with self._lock:
            self._settle()
            self._is_paused = True

    def resume(self) -> None:
        """Continue after `pause`."""
        with self._lock:
            self._settle()
            self._is_paused = False

    def _settle(self) -> None:
        self._begin_at(self._now_ns())

    def _begin_at(self, time_ns: int) -> None:
        self._anchor_ns = time_ns
        self._set_at_s = self._asked_at_s = time.perf_counter()

    def _now_ns(self) -> int:
        if self._is_paused:
            return self._anchor_ns
        return self._anchor_ns + int(self._passed_s() * self._rate * S_TO_NS)

    def _passed_s(self) -> float:
        """Return the seconds since `_begin_at` in which the program was not suspended."""
        now_s = time.perf_counter()
        gap_s = now_s - self._asked_at_s
        if gap_s > _SUSPENDED_S:
            self._set_at_s += gap_s
        self._asked_at_s = now_s
        return now_s - self._set_at_s
