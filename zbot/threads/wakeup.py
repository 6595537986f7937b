"""Wake-ups between threads: a binary semaphore, and busy waiting for messages that come soon.

A sleeping thread takes 10 to 30 us to wake, which is a large part of a small message's time. So a
thread that has just sent something polls for the answer for a short time before it sleeps, if its
last wait was short. It yields its core between the polls. This halves the time of round trips, and
takes no more CPU time than two threads that sleep and wake. A thread that has sent nothing polls
only in a flood of messages. All polling of a process costs at most a tenth of a core
(docs/design/receiving.md).
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
import time
from functools import partial
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

# On Windows, Ctrl-C does not interrupt a lock's acquire(). On other systems, Ctrl-C does not
# interrupt acquire() if it comes just before Python goes to sleep.
#: The longest single wait, in seconds. Python handles Ctrl-C between two single waits.
LONGEST_WAIT_S = 0.1 if sys.platform == "win32" else 0.5
# A round trip of 64 B to 1 MB between two processes of one machine takes 60 to 400 us.
_SHORT_WAIT_NS = 500_000
#: `short_wait_ns` for large messages. Their round trip takes 2 ms on a slow virtual machine.
LARGE_MESSAGE_WAIT_NS = 3_000_000
_LONG_NS = sys.maxsize
# Up to these times, polling takes no more CPU time than sleeping and waking. An answer also wakes
# threads of the other process, which sleep less deeply if it comes soon.
_FREE_NS = 80_000
_FREE_FOR_ANSWER_NS = 200_000
_SECOND_NS = 1_000_000_000
_BUDGET_NS = 100_000_000
# If another program needs the core, it runs for longer than this when the polling thread yields.
# The threads of Zenoh, which bring the message, need less.
_OTHERS_NS = 500_000
_PAUSE_NS = 50_000_000

_yield: Callable[[], None] = getattr(os, "sched_yield", partial(time.sleep, 0))


class Activity:
    """What the threads of this process do, as far as it decides whether they poll."""

    __slots__ = ("_budget_ns", "_pause_end_ns", "_second_end_ns", "has_sent")

    def __init__(self) -> None:
        self.has_sent = False  #: whether something was sent since the last wait began
        self._budget_ns = _BUDGET_NS
        self._second_end_ns = 0
        self._pause_end_ns = 0

    def can_poll(self, now_ns: int) -> bool:
        """Return whether no other program needs the core, and time of this second is left."""
        if now_ns >= self._second_end_ns:
            self._budget_ns, self._second_end_ns = _BUDGET_NS, now_ns + _SECOND_NS
        return self._budget_ns > 0 and now_ns >= self._pause_end_ns

    def spend(self, time_ns: int) -> None:
        """Note CPU time that polling took and sleeping would not have taken."""
        self._budget_ns -= max(time_ns, 0)

    def pause(self, now_ns: int) -> None:
        """Let no thread poll for a while, because another program needs the core."""
        self._pause_end_ns = now_ns + _PAUSE_NS


activity = Activity()


class BusyWait:
    """Polls for a short time at the beginning of a wait, if the last wait was short.

    Several threads may share a `BusyWait`. Then the last wait of one thread decides whether another
    thread polls.
    """

    def __init__(self) -> None:
        self.short_wait_ns = _SHORT_WAIT_NS  #: a wait for an answer up to this time is short
        self._last_ns = _LONG_NS
        self._begun_ns = 0

    def begin(self, has_come: Callable[[], object]) -> bool:
        """Begin to wait. Return whether the event came during the polling.

        Args:
            has_come: Returns true when the event has come. It is called repeatedly or never.
        """
        self._begun_ns = begun_ns = time.monotonic_ns()
        longest_ns = free_ns = _FREE_NS
        if activity.has_sent:
            activity.has_sent = False
            longest_ns, free_ns = self.short_wait_ns, _FREE_FOR_ANSWER_NS
        if self._last_ns >= longest_ns or not activity.can_poll(begun_ns):
            return False
        came = self._poll(has_come, longest_ns)
        polled_ns = time.monotonic_ns() - begun_ns
        activity.spend(polled_ns - free_ns * came)
        if came:
            self._last_ns = polled_ns
        return came

    def _poll(self, has_come: Callable[[], object], longest_ns: int) -> bool:
        now_ns, end_ns = self._begun_ns, self._begun_ns + longest_ns
        while not has_come():
            _yield()  # releases the interpreter's lock
            before_ns, now_ns = now_ns, time.monotonic_ns()
            if now_ns >= end_ns:
                if now_ns - before_ns > _OTHERS_NS:
                    activity.pause(now_ns)
                return bool(has_come())
        return True

    def end(self, *, came: bool) -> None:
        """End a wait. The wait counts as short only if the event came."""
        self._last_ns = time.monotonic_ns() - self._begun_ns if came else _LONG_NS


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


class WakerSource(Protocol):
    """Calls functions when something has happened, e.g. a future, or a context that shuts down."""

    def add_waker(self, waker: Callable[[], None]) -> None:
        """Call a quick function from now on."""
        ...

    def remove_waker(self, waker: Callable[[], None]) -> None:
        """Stop calling a function that was given to `add_waker`."""
        ...


@contextlib.contextmanager
def waking(waker: Callable[[], None], *sources: WakerSource) -> Iterator[None]:
    """Let sources call a quick function during a `with` block."""
    for source in sources:
        source.add_waker(waker)
    try:
        yield
    finally:
        for source in sources:
            source.remove_waker(waker)
