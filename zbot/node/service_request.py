"""Requests of service calls: they are repeated after a timeout, and a server runs each once."""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from typing import TYPE_CHECKING, Any

from zbot.memory import LARGE_BYTES
from zbot.node.errors import ServiceError
from zbot.wire.attachment import GID_LENGTH
from zbot.wire.error_reply import unpack_error

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    Reply = Callable[[zenoh.Query], None]

# Zenoh keeps 0.8 kB for each query until the query's timeout, even if the reply came long before.
# So the timeout is short, and the request is repeated at growing intervals (docs/wire.md).
_FIRST_TIMEOUT_S = 2.0
_LONGEST_TIMEOUT_S = 60.0
_TIMEOUT_REPLY = b"Timeout"  # Zenoh's own error reply after the timeout
# After this time, a reply counts as late. Its query may end soon: the timeout is 2 s or more.
_LATE_S = 1.0
# A server keeps at most this many late replies, and the latest quick reply of this many clients. A
# further one removes the oldest.
_MAX_ANSWERS = 32
_MAX_LATE_BYTES = 1 << 25  # of all late replies together. The newest is always kept.


class ServiceRequest:
    """Encoded request, which is sent again after each timeout of its Zenoh query.

    Args:
        payload: The encoded request.
        attachment: Number and gid of the request. Each repetition has the same number and gid, so
            that the server runs its callback once.
        timeout_s: Seconds until the call fails. With `None`, the call does not fail, and the
            request is repeated.
    """

    __slots__ = ("_has_timed_out", "_is_repeated", "attachment", "payload", "timeout_s")

    def __init__(self, payload: Any, attachment: bytes, *, timeout_s: float | None = None) -> None:
        self.payload = payload
        self.attachment = attachment
        self._is_repeated = timeout_s is None
        self._has_timed_out = False
        self.timeout_s = _FIRST_TIMEOUT_S if timeout_s is None else timeout_s

    def is_timeout(self, reply: zenoh.Reply) -> bool:
        """Return whether a reply is a timeout of Zenoh, and the request is to be repeated.

        One attempt may time out twice: in this session and in the server's session.
        """
        if not self._is_repeated or reply.ok is not None or reply.err is None:
            return False
        if reply.err.payload.to_bytes() != _TIMEOUT_REPLY:
            return False
        self._has_timed_out = True
        return True

    def is_to_be_repeated(self) -> bool:
        """After an attempt, return whether it timed out. If it did, double the next timeout."""
        if not self._has_timed_out:
            return False
        self._has_timed_out = False
        self.timeout_s = min(2 * self.timeout_s, _LONGEST_TIMEOUT_S)
        return True


def response_sample(reply: zenoh.Reply | None, service: str) -> zenoh.Sample:
    """Return the sample with the response in a reply.

    Args:
        reply: The reply, or `None` if the server ended without a reply.
        service: Full name of the service.

    Raises:
        ServiceError: The reply is an error, or there is none.
    """
    if reply is None:
        raise ServiceError(service, "server_gone", "the server ended before it answered")
    if reply.ok is None:
        payload = b"" if reply.err is None else reply.err.payload.to_bytes()
        raise ServiceError(service, *unpack_error(payload))
    return reply.ok


class RepeatedRequests:
    """Stores a server's running requests and some replies. Any thread may call the methods.

    A late reply may come after the timeout of its query. The network may also hold up a quick reply
    for longer than that, e.g. while a laptop changes to another access point. So the latest quick
    reply of each client is kept too.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._working: dict[bytes, tuple[zenoh.Query, float]] = {}
        self._late: OrderedDict[bytes, tuple[Reply, int]] = OrderedDict()  # with their sizes
        # By the client's gid. The first value is the request.
        self._latest: OrderedDict[bytes, tuple[bytes, Reply]] = OrderedDict()

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
            reply, _ = self._late.get(request, (None, 0))
            if reply is None:
                known, reply = self._latest.get(request[-GID_LENGTH:], (b"", None))
                reply = reply if known == request else None
            if reply is None:
                former = self._working.get(request)
                self._working[request] = (query, arrived_s if former is None else former[1])
                return former is None
        reply(query)
        return False

    def end(self, request: bytes, query: zenoh.Query, reply: Reply, size: int) -> zenoh.Query:
        """End a request, and return its latest query, to which the reply must be sent.

        The reply is kept, because the client may repeat the request. A quick reply that is large is
        not kept.

        Args:
            request: As in `is_new`.
            query: The query that came first.
            reply: Sends the reply.
            size: Bytes of the reply.
        """
        with self._lock:
            latest, arrived_s = self._working.pop(request, (query, 0.0))
            if time.monotonic() - arrived_s > _LATE_S:
                self._keep_late(request, reply, size)
            elif size < LARGE_BYTES:
                _keep(self._latest, request[-GID_LENGTH:], (request, reply))
        return latest

    def _keep_late(self, request: bytes, reply: Reply, size: int) -> None:
        _keep(self._late, request, (reply, size))
        while (
            len(self._late) > 1 and sum(size for _, size in self._late.values()) > _MAX_LATE_BYTES
        ):
            self._late.popitem(last=False)


def _keep(kept: OrderedDict[bytes, Any], key: bytes, value: Any) -> None:
    kept[key] = value
    kept.move_to_end(key)
    if len(kept) > _MAX_ANSWERS:
        kept.popitem(last=False)
