"""Threads that sleep on a clock, and threads that have woken up a moment ago."""

from __future__ import annotations

import threading
import time

#: A thread that does not sleep again within this time does something else now.
_AWAKE_S = 0.5


class Sleepers:
    """Threads that sleep on one clock, so that a simulator can wait for their work.

    A program with a loop and a `Rate` works in the thread of the loop, and not in callbacks. It has
    done its work when it sleeps again.
    """

    def __init__(self) -> None:
        self._asleep: dict[int, int] = {}  # when each thread wakes up, by its number
        self._awake: dict[int, float] = {}  # when the work of each thread ends at the latest

    def begin(self, until_ns: int) -> None:
        """Note that the calling thread sleeps until a time of the clock."""
        me = threading.get_ident()
        self._asleep[me] = until_ns
        self._awake.pop(me, None)

    def end(self) -> None:
        """Note that the calling thread has woken up."""
        me = threading.get_ident()
        self._awake[me] = time.monotonic() + _AWAKE_S
        self._asleep.pop(me, None)

    def are_busy(self, now_ns: int) -> bool:
        """Return whether another thread than the calling one works, or will wake up at once."""
        me, now_s = threading.get_ident(), time.monotonic()
        for thread, end_s in list(self._awake.items()):
            if end_s <= now_s:
                self._awake.pop(thread, None)
        return any(thread != me for thread in self._awake) or any(
            until_ns <= now_ns for until_ns in list(self._asleep.values())
        )
