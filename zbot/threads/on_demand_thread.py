"""Thread that exists only while there is work for it."""

from __future__ import annotations

import contextlib
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable


class OnDemandThread:
    """Runs work in a thread that ends when there is no more work, so that an idle node has none.

    Args:
        start: Starts a thread that runs a function.
        work: Does a part of the work. It returns the seconds until its next call, or `None` if
            nothing is left to do. A call of `wake` begins its next call at once.
    """

    def __init__(
        self, start: Callable[[Callable[[], None]], object], work: Callable[[], float | None]
    ) -> None:
        self._start = start
        self._work = work
        # Locks are safe in a signal handler and in Zenoh's threads. A condition variable is not.
        self._exists = threading.Lock()  # held while there is a thread
        self._is_quiet = threading.Lock()  # released by `wake`
        self._is_quiet.acquire()

    def wake(self) -> None:
        """Let the work begin now. Any thread may call this, and a signal handler too."""
        self._hurry()
        if self._exists.acquire(blocking=False):
            try:
                self._start(self._run)
            except RuntimeError:  # no thread can be started any more: the process ends
                self._exists.release()

    def _hurry(self) -> None:
        with contextlib.suppress(RuntimeError):  # it was released already
            self._is_quiet.release()

    def end(self) -> None:
        """Let a thread do its work now. If there is none, never start one."""
        self._exists.acquire(blocking=False)
        self._hurry()

    def _run(self) -> None:
        while True:
            try:
                self._work_until_done()
            finally:
                self._exists.release()
            # A `wake` that came before the release has started no thread.
            if self._is_quiet.locked() or not self._exists.acquire(blocking=False):
                return

    def _work_until_done(self) -> None:
        pause_s: float | None = 0.0
        while pause_s is not None:
            self._is_quiet.acquire(timeout=min(pause_s, threading.TIMEOUT_MAX))
            pause_s = self._work()
