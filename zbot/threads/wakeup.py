"""Wake-ups between threads: a binary semaphore, and busy waiting for messages that come soon.

A sleeping thread takes 10 to 30 us to wake, which is a large part of a small message's time. So if
a thread's last wait was short, it polls for a short time before it sleeps, and yields its core
between the polls. This halves the time of round trips. If its last wait was longer, such as for the
messages of a 1 kHz topic, the thread sleeps immediately. While small messages come every 0.1 to
0.5 ms, or large messages every 3 ms, busy waiting uses a core that would be idle otherwise.
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

# On Windows, Ctrl-C does not interrupt a lock's acquire(). On other systems, Ctrl-C does not
# interrupt acquire() if it comes just before Python goes to sleep.
#: The longest single wait, in seconds. Python handles Ctrl-C between two single waits.
LONGEST_WAIT_S = 0.1 if sys.platform == "win32" else 0.5
# A round trip of 64 B to 1 MB between two processes of one machine takes 60 to 400 us.
_SHORT_WAIT_NS = 500_000
#: `short_wait_ns` for large messages. Their round trip takes 2 ms on a slow virtual machine.
LARGE_MESSAGE_WAIT_NS = 3_000_000

_yield: Callable[[], None] = getattr(os, "sched_yield", partial(time.sleep, 0))


class BusyWait:
    """Polls for a short time at the beginning of a wait, if the last wait was short.

    Several threads may share a `BusyWait`. Then the last wait of one thread decides whether another
    thread polls.
    """

    def __init__(self) -> None:
        self.short_wait_ns = _SHORT_WAIT_NS  #: a wait up to this time is short
        self._was_short = False
        self._begun_ns = 0

    def begin(self, has_come: Callable[[], object]) -> bool:
        """Begin to wait. Return whether the event came during the polling.

        Args:
            has_come: Returns true when the event has come. It is called repeatedly or never.
        """
        self._begun_ns = time.monotonic_ns()
        if self._was_short:
            end_ns = self._begun_ns + self.short_wait_ns
            while not has_come():
                _yield()  # releases the interpreter's lock
                if time.monotonic_ns() >= end_ns:
                    return False
            return True
        return False

    def end(self, *, came: bool) -> None:
        """End a wait. The wait counts as short only if the event came."""
        self._was_short = came and time.monotonic_ns() - self._begun_ns < self.short_wait_ns


class BinarySemaphore:
    """Semaphore that is set or not set. Any thread may call `set`, but only one may call `wait`."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._lock.acquire()
        self._is_set = partial(self._lock.acquire, blocking=False)
        self._busy_wait = BusyWait()

    def set(self) -> None:
        """Let the current or the next `wait` return. More calls before that have no effect."""
        try:
            self._lock.release()
        except RuntimeError:
            return  # it is set already

    def wait(self, timeout_s: float) -> bool:
        """Wait up to `min(timeout_s, LONGEST_WAIT_S)` seconds. Return whether `set` was called."""
        if timeout_s > _SHORT_WAIT_NS / 1e9 and self._busy_wait.begin(self._is_set):
            return True
        was_set = self._lock.acquire(timeout=min(timeout_s, LONGEST_WAIT_S))
        self._busy_wait.end(came=was_set)
        return was_set
