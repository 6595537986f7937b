"""Service servers, which answer requests with a callback."""

from __future__ import annotations

import time
from collections import deque
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import zenoh

from zbot.executor.forgotten_spin import Program
from zbot.interfaces.same_type import is_message_of
from zbot.log import get_logger
from zbot.memory import LARGE_BYTES, keep_freed_memory
from zbot.node.errors import response_type_error
from zbot.node.service_introspection import ServiceEndpoint, Step
from zbot.node.service_request import RepeatedRequests
from zbot.threads.foreign_call import called_by_zenoh, keep_thread_state
from zbot.threads.handle import Handle
from zbot.threads.wakeup import activity
from zbot.wire.attachment import GID_LENGTH, LAYOUT, NUMBER, unpack
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.wire.tokens import EndpointToken

RequestT = TypeVar("RequestT")
ResponseT = TypeVar("ResponseT")


class Service(ServiceEndpoint, Generic[RequestT, ResponseT]):
    """Answers the requests of a service with a callback. `Node.create_service` creates services.

    If the callback raises an exception, the caller gets a `ServiceError`. `spin()` raises the
    exception too, as for any other callback. Requests are served in the order of arrival.

    Args:
        context: The context whose session receives the requests.
        srv_type: Service class.
        callback: Takes a request and an empty response, and returns a response. The callback may
            be a coroutine function.
        token: The server's liveliness token: its node, service, type and profile.
        ready_queue: The queue that the node's executor takes ready entities from.
        callback_group: Decides which other callbacks may run at the same time.
        logger_name: Name of the node's logger.
    """

    due_ns: int | None = None

    def __init__(
        self,
        context: Context,
        srv_type: Any,
        callback: Callable[[RequestT, ResponseT], Any],
        token: EndpointToken,
        *,
        ready_queue: ReadyQueue,
        callback_group: CallbackGroup,
        logger_name: str,
    ) -> None:
        self.srv_type = srv_type
        self.srv_name = token.name
        self.callback = callback
        self.callback_group = callback_group
        self.ready_queue = ready_queue
        self._wakers: list[Callable[[], None]] = []
        self._context = context
        self._token = token
        self._logger_name = logger_name
        dialect = context.dialect
        self._encoding = zenoh.Encoding(dialect.encoding(f"{token.type_name}_Response"))
        self._key = zenoh.KeyExpr(dialect.data_key(token))
        self._queries: deque[tuple[zenoh.Query, float]] = deque()
        self._repeated = RepeatedRequests()
        self._is_destroyed = False
        # Zenoh's own thread calls `_receive`. To wake another thread for each request costs time.
        receive: Any = zenoh.handlers.Callback(self._receive, indirect=False)
        self._queryable: Any = context.session.declare_queryable(self._key, receive, complete=True)
        self._announcement = context.graph.announce(token)

    # The first request loads these codecs, because most services of a node get no request.
    @cached_property
    def _decode(self) -> Callable[[Any], RequestT]:
        return self._context.dialect.codec_for(self.srv_type.Request).decode

    @cached_property
    def _encode(self) -> Callable[[Any], Any]:
        return self._context.dialect.codec_for(self.srv_type.Response).encode

    @property
    def is_destroyed(self) -> bool:
        """Whether the server was destroyed."""
        return self._is_destroyed

    @property
    def handle(self) -> ServiceHandle:
        """A handle for a `WaitSet`. A program can also take requests from the handle."""
        return ServiceHandle(self)

    def take_request(self) -> tuple[RequestT, RequestHeader] | None:
        """Remove and return the oldest request, or return `None`. The callback is not called.

        Raises:
            CodecError: The request cannot be decoded.
        """
        Program.takes_itself = True
        taken = self.take()
        if taken is None:
            return None
        query = taken[0]
        payload = b"" if query.payload is None else query.payload.to_bytes()
        attachment = query.attachment
        facts = unpack(None if attachment is None else attachment.to_bytes())
        return self._decode(payload), RequestHeader(query, 0 if facts is None else facts.source_ns)

    def send_response(self, response: ResponseT, header: RequestHeader) -> None:
        """Answer a request that `take_request` returned.

        Raises:
            WrongTypeError: The argument is not a response of this service.
        """
        self._answer(request_id_of(header.query), header.query, response)

    @called_by_zenoh
    def _receive(self, query: zenoh.Query) -> None:
        # Zenoh's thread runs this function. So the function only puts the request into the queue.
        keep_thread_state()
        self._queries.append((query, time.monotonic()))
        if self._is_destroyed:
            self._drop_queries()
        for waker in list(self._wakers):
            waker()
        self.ready_queue.post(self)

    def add_waker(self, waker: Callable[[], None]) -> None:
        """Call a quick function for each request, in Zenoh's thread."""
        self._wakers.append(waker)

    def remove_waker(self, waker: Callable[[], None]) -> None:
        """Stop calling a function that was given to `add_waker`."""
        self._wakers.remove(waker)

    @property
    def has_work(self) -> bool:
        """Whether there is a request to serve."""
        return bool(self._queries)

    def take(self) -> tuple[zenoh.Query, float] | None:
        """Return the oldest request and its time of arrival (monotonic, seconds), if any."""
        try:
            return self._queries.popleft()
        except IndexError:
            return None

    def execute(self, taken: tuple[zenoh.Query, float]) -> Coroutine[Any, Any, None] | None:
        """Decode a request, call the callback and send the response."""
        query, arrived_s = taken
        request_id = request_id_of(query)
        if request_id and not self._repeated.is_new(request_id, query, arrived_s):
            return None
        payload = b"" if query.payload is None else query.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
        try:
            self._check_type(query)
            request = self._decode(payload)
        except CodecError as exc:
            self._reply_error(request_id, query, exc)
            get_logger(self._logger_name).error(
                f"{self.service_name}: cannot read a request: {exc}"
            )
            return None
        if self._introspection is not None:
            self._introspection.report(Step.REQUEST_RECEIVED, request_id, request=request)
        try:
            outcome = self.callback(request, self.srv_type.Response())
            if outcome is not None and hasattr(outcome, "send"):
                return self._answer_later(request_id, query, outcome)
            self._answer(request_id, query, outcome)
        except Exception as exc:
            self._reply_error(request_id, query, exc)
            raise
        return None

    def _check_type(self, query: zenoh.Query) -> None:
        expected = f"{self._token.type_name}_Request"
        dialect, attachment = self._context.dialect, query.attachment
        reason = dialect.refusal(query.key_expr, query.encoding or "", expected)
        length = None if attachment is None else len(attachment.to_bytes())
        if length != LAYOUT.size:
            reason = dialect.attachment_refusal(length) or reason
        if reason:
            raise CodecError("decode", expected, "", reason)

    async def _answer_later(
        self, request_id: bytes, query: zenoh.Query, outcome: Coroutine[Any, Any, Any]
    ) -> None:
        try:
            self._answer(request_id, query, await outcome)
        except Exception as exc:
            self._reply_error(request_id, query, exc)
            raise

    def _answer(self, request_id: bytes, query: zenoh.Query, response: Any) -> None:
        expected = self.srv_type.Response
        if response.__class__ is not expected and not is_message_of(response, expected):
            raise response_type_error(self.service_name, expected, response)
        self._reply_payload(request_id, query, self._encode(response), response)

    def _reply_payload(
        self, request_id: bytes, query: zenoh.Query, payload: Any, response: Any = None
    ) -> None:
        size = len(payload)
        if size >= LARGE_BYTES:
            keep_freed_memory()
            payload = self._context.share(payload)
        facts = request_id and LAYOUT.pack(
            _number(request_id), time.time_ns(), GID_LENGTH, request_id[NUMBER.size :]
        )
        if self._introspection is not None:
            # This event is published before the reply is sent. So the event comes before the event
            # that the client publishes when it receives the reply.
            self._introspection.report(Step.RESPONSE_SENT, request_id, response=response)
        self._send_reply(
            request_id,
            query,
            lambda latest: latest.reply(
                self._key, payload, encoding=self._encoding, attachment=facts or None
            ),
            size,
        )

    def _reply_error(self, request_id: bytes, query: zenoh.Query, error: Exception) -> None:
        payload, encoding = self._context.dialect.error_payload(error)
        self._send_reply(
            request_id,
            query,
            lambda latest: latest.reply_err(payload, encoding=encoding),
            len(payload),
        )

    def _send_reply(
        self,
        request_id: bytes,
        query: zenoh.Query,
        send: Callable[[zenoh.Query], None],
        size: int,
    ) -> None:
        def reply(query: zenoh.Query) -> None:
            try:
                send(query)
            except zenoh.ZError:
                # The context was shut down during the callback. The caller gets a `ServiceError`.
                if not self._context.is_closed:
                    raise
            finally:
                query.drop()  # ends the query, so that the caller does not wait for more replies

        activity.has_sent = True
        if request_id:
            query = self._repeated.end(request_id, query, reply, size)
        reply(query)

    def destroy(self) -> None:
        """Leave the graph and let waiting requests fail. This method may be called twice."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        self.end_introspection()
        self._context.undeclare(self._announcement, self._queryable)
        if not self._context.is_inherited:
            self._drop_queries()

    def _drop_queries(self) -> None:
        while (taken := self.take()) is not None:
            taken[0].drop()  # the caller gets a `ServiceError`


@dataclass(frozen=True)
class RequestHeader:
    """Header of a request that a program took without an executor."""

    query: zenoh.Query
    source_timestamp: int  #: nanoseconds since the epoch by the caller's clock, or 0 if unknown
    received_timestamp: int = field(default_factory=time.time_ns)  #: by this machine's clock

    @property
    def request_id(self) -> RequestHeader:
        """What has the attribute `sequence_number` in rclpy."""
        return self

    @property
    def sequence_number(self) -> int:
        """The number of the caller's request, or 0 if it is unknown."""
        request_id = request_id_of(self.query)
        return _number(request_id) if request_id else 0


class ServiceHandle(Handle[Service[Any, Any]]):
    """A service's handle."""

    def service_take_request(
        self,
        request_type: object = None,  # noqa: ARG002 - rclpy's signature
    ) -> tuple[Any, RequestHeader] | tuple[None, None]:
        """Remove and return the oldest request, or return `(None, None)`. No callback runs."""
        return self.entity.take_request() or (None, None)

    def service_send_response(self, response: Any, header: RequestHeader) -> None:
        """Answer a request that `service_take_request` returned."""
        self.entity.send_response(response, header)


def request_id_of(query: zenoh.Query) -> bytes:
    """Return a request's number and its client's gid, or empty bytes if these are missing."""
    attachment = query.attachment
    facts = b"" if attachment is None else attachment.to_bytes()
    return facts[: NUMBER.size] + facts[-GID_LENGTH:] if len(facts) == LAYOUT.size else b""


def _number(request_id: bytes) -> int:
    number: int = NUMBER.unpack_from(request_id)[0]
    return number
