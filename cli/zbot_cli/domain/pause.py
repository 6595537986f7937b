"""Waiting between two messages, which Ctrl-C cuts short."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from zbot.transport.wakeup import BinarySemaphore

if TYPE_CHECKING:
    from zbot.context import Context


class Pause:
    """Waits that a context's end cuts short."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._end = BinarySemaphore()  # a signal handler sets it: an Event could wait for itself
        context.add_waker(self._end.set)

    def until(self, time_s: float) -> None:
        """Wait until the monotonic clock shows a time."""
        while self._context.ok() and (left := time_s - time.monotonic()) > 0:
            self._end.wait(left)
