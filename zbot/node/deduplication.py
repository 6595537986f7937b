"""Store of service requests, so that a server runs its callback once for a repeated request.

Zenoh keeps memory for a query until the query's timeout. So a client of zbot sets a short timeout.
If the reply takes longer, the client sends the request again, with the same number and gid.
"""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

# After this time, a reply counts as late. Its query may end soon: the timeout is 2 s or more.
_LATE_S = 1.0
# A server keeps at most this many late replies. A further late reply removes the oldest.
_MAX_ANSWERS = 32


class RepeatedRequests:
    """Stores a server's running requests and late replies. Any thread may call the methods."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._working: dict[bytes, tuple[zenoh.Query, float]] = {}
        self._answered: OrderedDict[bytes, Callable[[zenoh.Query], None]] = OrderedDict()

    def is_new(self, request: bytes, query: zenoh.Query, arrived_s: float) -> bool:
        """Return whether a request is new. A repeated request gets the reply of the first request.

        If the callback still runs, the reply is sent later.

        Args:
            request: The request's number and its client's gid. Every repetition has the same bytes.
            query: The Zenoh query to reply to.
            arrived_s: Time of arrival by the monotonic clock, in seconds.
        """
        with self._lock:
            # Keep the reply: if this query is closed already, a later repetition needs the reply.
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
        """End a request, and return its latest query, to which the reply must be sent.

        A late reply is kept, because the client may repeat the request.
        """
        with self._lock:
            latest, arrived_s = self._working.pop(request, (query, 0.0))
            if time.monotonic() - arrived_s > _LATE_S:
                self._answered[request] = reply
                while len(self._answered) > _MAX_ANSWERS:
                    self._answered.popitem(last=False)
        return latest
