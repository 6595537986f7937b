"""Requests that are sent again, and are to be served once.

Zenoh gives a query a time, and keeps memory for it until then. A client of zbot gives it little,
and repeats a request that takes longer, with the same number and gid, while its caller waits.
"""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

# An answer that took this long may find its query's time over: 2 s is the shortest that it has.
_LATE_S = 1.0
# Callers may have given up, so late answers are not kept for ever.
_MOST_KEPT = 32


class Repetitions:
    """What a server does at present, and what it answered late. For any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._working: dict[bytes, tuple[zenoh.Query, float]] = {}
        self._answered: OrderedDict[bytes, Callable[[zenoh.Query], None]] = OrderedDict()

    def is_new(self, request: bytes, query: zenoh.Query, arrived_s: float) -> bool:
        """Return whether a request is to be served; a repeated one is dealt with here.

        Args:
            request: Number and sender, the same in every repetition.
            query: What to reply to.
            arrived_s: When it came, by the monotonic clock.
        """
        with self._lock:
            # It stays: of several repetitions that waited here, only the last one is still open.
            reply = self._answered.get(request)
            if reply is None:
                former = self._working.get(request)
                self._working[request] = (query, arrived_s if former is None else former[1])
                return former is None
        reply(query)
        return False

    def end(
        self, request: bytes, query: zenoh.Query, reply: Callable[[zenoh.Query], None]
    ) -> zenoh.Query:
        """Return the query to reply to: the latest; keep the answer in case that it is too late."""
        with self._lock:
            latest, arrived_s = self._working.pop(request, (query, 0.0))
            if time.monotonic() - arrived_s > _LATE_S:
                self._answered[request] = reply
                while len(self._answered) > _MOST_KEPT:
                    self._answered.popitem(last=False)
        return latest
