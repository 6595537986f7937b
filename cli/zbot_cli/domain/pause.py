"""Pause between two messages. Ctrl-C ends it early."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from zbot.threads.wakeup import BinarySemaphore

if TYPE_CHECKING:
    from zbot.context import Context


class Pause:
    """Object that waits for a point in time. It also stops waiting when its context ends."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._end = BinarySemaphore()  # set by a signal handler, in which an Event could deadlock
        context.add_waker(self._end.set)

    def until(self, time_s: float) -> None:
        """Wait until `time.monotonic()` reaches `time_s`, or the context ends."""
        while self._context.ok() and (left := time_s - time.monotonic()) > 0:
            self._end.wait(left)
