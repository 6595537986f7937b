"""Request of a service call, and the future of its response."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from zbot.executor.task import Future
from zbot.threads.foreign_call import called_by_zenoh, keep_thread_state
from zbot.wire.attachment import LAYOUT

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh
    from typing_extensions import Self

    from zbot.node.client import Client

ResponseT = TypeVar("ResponseT")

# Zenoh keeps 0.8 kB for each query until the query's timeout, even if the reply came long before.
# So the timeout is short, and the request is repeated at growing intervals (docs/wire.md).
_FIRST_TIMEOUT_S = 2.0
_LONGEST_TIMEOUT_S = 60.0
_TIMEOUT_REPLY = b"Timeout"  # Zenoh's own error reply after the timeout


class ServiceRequest:
    """Encoded request, which is sent again after each timeout of its Zenoh query.

    Args:
        payload: The encoded request.
        attachment: Number and gid of the request. Each repetition has the same number and gid, so
            that the server runs its callback once.
        timeout_s: Seconds until the call fails. With `None`, the call does not fail, and the
            request is repeated.
    """

    __slots__ = ("_is_repeated", "attachment", "payload", "timeout_s")

    def __init__(self, payload: Any, attachment: bytes, *, timeout_s: float | None = None) -> None:
        self.payload = payload
        self.attachment = attachment
        self._is_repeated = timeout_s is None
        self.timeout_s = _FIRST_TIMEOUT_S if timeout_s is None else timeout_s

    def is_to_be_repeated(self, reply: zenoh.Reply) -> bool:
        """Return whether a reply is a timeout of Zenoh. If it is, double the next timeout."""
        if not self._is_repeated or reply.ok is not None or reply.err is None:
            return False
        if reply.err.payload.to_bytes() != _TIMEOUT_REPLY:
            return False
        self.timeout_s = min(2 * self.timeout_s, _LONGEST_TIMEOUT_S)
        return True


class ResponseFuture(Future[ResponseT]):
    """Future of a response. The client's executor runs the future's callbacks."""

    def __init__(self, client: Client[Any, ResponseT], request: ServiceRequest) -> None:
        super().__init__()
        self._client = client
        self._request = request
        self._attempt = 0
        self._is_to_be_repeated = False

    @property
    def number(self) -> int:
        """The request's number. The first request of a client has the number 1."""
        number: int = LAYOUT.unpack(self._request.attachment)[0]
        return number

    def send(self) -> None:
        """Send the request, for the first time or again."""
        self._attempt += 1
        ended = partial(self._on_end, self._attempt)
        self._client.send(self._request, self._on_reply, ended)

    @called_by_zenoh
    def _on_reply(self, reply: zenoh.Reply) -> None:
        keep_thread_state()
        if self._request.is_to_be_repeated(reply):
            # One attempt may time out twice: in this session and in the server's session.
            self._is_to_be_repeated = True
        else:
            self._client.complete(self, reply)

    @called_by_zenoh
    def _on_end(self, attempt: int) -> None:
        if attempt != self._attempt or self.is_over:
            return
        if not self._is_to_be_repeated:
            self._client.complete(self, None)
        elif self._client.is_pending(self):
            self._is_to_be_repeated = False
            self.send()

    @property
    def has_callbacks(self) -> bool:
        """Whether a callback is to run when the call is over."""
        return bool(self._callbacks)

    def _run_callbacks(self) -> None:
        # The executor runs the callbacks. This call also makes a waiting `spin_once` return.
        self._client.post(self)

    def add_done_callback(self, callback: Callable[[Self], Any]) -> None:
        """Let the executor call `callback(self)` as soon as the future is over."""
        with self._lock:
            self._callbacks.append(callback)
            if not self.is_over:
                return
        self._client.post(self)

    def pop_callbacks(self) -> list[Callable[[Any], Any]]:
        """Return and forget the callbacks that have not run."""
        return self._pop_callbacks()
