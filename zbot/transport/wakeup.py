"""Waiting for another thread: asleep as a rule, for a moment wide awake when work comes quickly.

To be woken takes a thread 10 to 30 us, which is much of a small message's way. So a thread whose
last wait was over at once looks again and again for a moment before it sleeps, and lets everybody
else run in between: round trips take half the time. Whoever waits longer than that moment, as for
the messages of a 1 kHz topic, sleeps at once. What comes every 0.1 to 0.5 ms, or large and every 3,
takes the time in which its core would be idle.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from functools import partial
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

# Ctrl-C does not interrupt a lock's acquire() on Windows, and elsewhere not if it comes just before
# Python goes to sleep: wait in slices.
#: Seconds.
LONGEST_WAIT_S = 0.1 if sys.platform == "win32" else 0.5
# A round trip between two processes of one machine takes 60 to 400 us, 64 B to 1 MB ...
_MOMENT_NS = 500_000
#: ... and with large messages 2 ms on a virtual one that copies and wakes slowly.
LARGE_MOMENT_NS = 3_000_000

_yield: Callable[[], None] = getattr(os, "sched_yield", partial(time.sleep, 0))


class BusyWait:
    """Tells whether one more short wait is to be expected, and waits through it awake.

    Threads that share one may sleep, or stay awake for a moment, where it was not worth it.
    """

    def __init__(self) -> None:
        self.moment_ns = _MOMENT_NS  #: up to this a wait is short
        self._was_short = False
        self._begun_ns = 0

    def begin(self, has_come: Callable[[], object]) -> bool:
        """Begin to wait; return whether what is waited for came in that moment.

        Args:
            has_come: Called again and again, if at all; true when it came.
        """
        self._begun_ns = time.monotonic_ns()
        if self._was_short:
            end_ns = self._begun_ns + self.moment_ns
            while not has_come():
                _yield()  # without the interpreter's lock
                if time.monotonic_ns() >= end_ns:
                    return False
            return True
        return False

    def end(self, *, came: bool) -> None:
        """Note whether what was waited for came; an end of patience tells nothing."""
        self._was_short = came and time.monotonic_ns() - self._begun_ns < self.moment_ns


class BinarySemaphore:
    """`set` it any number of times, `wait` for at least one of them; one thread may wait."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._lock.acquire()
        self._is_set = partial(self._lock.acquire, blocking=False)
        self._busy_wait = BusyWait()

    def set(self) -> None:
        """Let the present or next `wait` return; from any thread."""
        try:
            self._lock.release()
        except RuntimeError:
            return  # set already

    def wait(self, timeout_s: float) -> bool:
        """Wait at most `timeout_s` seconds and `LONGEST_WAIT_S`; return whether it was set."""
        if timeout_s > _MOMENT_NS / 1e9 and self._busy_wait.begin(self._is_set):
            return True
        was_set = self._lock.acquire(timeout=min(timeout_s, LONGEST_WAIT_S))
        self._busy_wait.end(came=was_set)
        return was_set
