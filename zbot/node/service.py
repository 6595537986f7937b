"""Services: a function that other processes call by name."""

from __future__ import annotations

import time
from collections import deque
from dataclasses import dataclass, field
from functools import cached_property
from struct import Struct
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import zenoh

from zbot.interfaces import type_name
from zbot.log import get_logger
from zbot.node.deduplication import Repetitions
from zbot.node.errors import ResponseTypeError
from zbot.node.service_introspection import ServiceEndpoint, Step
from zbot.process.memory import LARGE_BYTES, keep_freed_memory
from zbot.transport.foreign_call import called_by_zenoh, keep_thread_state
from zbot.transport.handle import Handle
from zbot.wire.attachment import GID_LENGTH, LAYOUT, unpack
from zbot.wire.codec import CodecError
from zbot.wire.dialect import other_type
from zbot.wire.error_reply import ENCODING, pack_error

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.wire.tokens import EndpointToken

RequestT = TypeVar("RequestT")
ResponseT = TypeVar("ResponseT")

_NUMBER = Struct("<q")  # how an attachment begins


class Service(ServiceEndpoint, Generic[RequestT, ResponseT]):
    """Answers the requests of a service with a function. Made by `Node.create_service`.

    What the function raises reaches the caller as `ServiceError`, and then leaves `spin()` like
    that of any other callback. Requests wait in the order of arrival until their turn.

    Args:
        context: The session to serve through.
        srv_type: Service class.
        callback: Takes a request and an empty response, and returns a response; may be a coroutine
            function.
        token: Who and where this server is.
        ready_queue: The node's way to its executor.
        callback_group: Decides beside what the callback may run.
        logger_name: The node's logger.
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
        self.watchers: list[Callable[[], object]] = []  #: called in Zenoh's thread for each request
        self._context = context
        self._token = token
        self._logger_name = logger_name
        dialect = context.dialect
        self._encoding = zenoh.Encoding(dialect.encoding(f"{token.type_name}_Response"))
        self._key = zenoh.KeyExpr(dialect.topic_key(context.get_domain_id(), token.name))
        self._queries: deque[tuple[zenoh.Query, float]] = deque()
        self._repetitions = Repetitions()
        self._is_destroyed = False
        # No thread of its own, for the same reason as below.
        receive: Any = zenoh.handlers.Callback(self._receive, indirect=False)
        self._queryable: Any = context.session.declare_queryable(self._key, receive, complete=True)
        self._liveliness = context.graph.announce(token)

    # Made with the first request: a node has half a dozen services that are hardly ever called.
    @cached_property
    def _decode(self) -> Callable[[Any], RequestT]:
        return self._context.dialect.codec_for(self.srv_type.Request).decode

    @cached_property
    def _encode(self) -> Callable[[Any], Any]:
        return self._context.dialect.codec_for(self.srv_type.Response).encode

    @property
    def is_destroyed(self) -> bool:
        """Whether it serves no more."""
        return self._is_destroyed

    @property
    def handle(self) -> ServiceHandle:
        """What a `WaitSet` takes, and what requests can be taken from without an executor."""
        return ServiceHandle(self)

    def take_request(self) -> tuple[RequestT, RequestHeader] | None:
        """Take the oldest request past the callback; `None` if there is none.

        Raises:
            CodecError: It cannot be read.
        """
        taken = self.take()
        if taken is None:
            return None
        query = taken[0]
        payload = b"" if query.payload is None else query.payload.to_bytes()
        attachment = query.attachment
        facts = unpack(None if attachment is None else attachment.to_bytes())
        return self._decode(payload), RequestHeader(query, 0 if facts is None else facts.source_ns)

    def send_response(self, response: ResponseT, header: RequestHeader) -> None:
        """Answer a request that was taken past the callback.

        Raises:
            ResponseTypeError: This is no response of this service.
        """
        self._answer(_sender(header.query), header.query, response)

    @called_by_zenoh
    def _receive(self, query: zenoh.Query) -> None:
        # Zenoh's thread: nothing but the hand-over.
        keep_thread_state()
        self._queries.append((query, time.monotonic()))
        if self._is_destroyed:
            self._drop_queries()
        for watcher in list(self.watchers):
            watcher()
        self.ready_queue.post(self)

    @property
    def has_work(self) -> bool:
        """Whether a request waits."""
        return bool(self._queries)

    def take(self) -> tuple[zenoh.Query, float] | None:
        """Return the oldest request that waits, and when it came (monotonic clock), if any."""
        try:
            return self._queries.popleft()
        except IndexError:
            return None

    def execute(self, taken: tuple[zenoh.Query, float]) -> Coroutine[Any, Any, None] | None:
        """Decode a request, call the callback and send what it returns."""
        query, arrived_s = taken
        who = _sender(query)
        if who and not self._repetitions.is_new(who, query, arrived_s):
            return None
        payload = b"" if query.payload is None else query.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
        try:
            self._check_type(query)
            request = self._decode(payload)
        except CodecError as exc:
            self._refuse(who, query, exc)
            get_logger(self._logger_name).error(
                f"{self.service_name}: cannot read a request: {exc}"
            )
            return None
        if self._introspection is not None:
            self._introspection.report(Step.REQUEST_RECEIVED, who, request=request)
        try:
            outcome = self.callback(request, self.srv_type.Response())
            if outcome is not None and hasattr(outcome, "send"):
                return self._answer_later(who, query, outcome)
            self._answer(who, query, outcome)
        except Exception as exc:
            self._refuse(who, query, exc)
            raise
        return None

    def _check_type(self, query: zenoh.Query) -> None:
        expected = f"{self._token.type_name}_Request"
        if reason := other_type(self._context.dialect, query.encoding or "", expected):
            raise CodecError("decode", expected, "", reason)

    async def _answer_later(
        self, who: bytes, query: zenoh.Query, outcome: Coroutine[Any, Any, Any]
    ) -> None:
        try:
            self._answer(who, query, await outcome)
        except Exception as exc:
            self._refuse(who, query, exc)
            raise

    def _answer(self, who: bytes, query: zenoh.Query, response: Any) -> None:
        expected = self.srv_type.Response
        if response.__class__ is not expected and not isinstance(response, expected):
            raise ResponseTypeError(self.service_name, type_name(expected), response)
        payload = self._encode(response)
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            payload = self._context.share(payload)
        facts = who and LAYOUT.pack(_number(who), time.time_ns(), GID_LENGTH, who[_NUMBER.size :])
        if self._introspection is not None:
            # Before the fact, so that nobody hears of the arrival first.
            self._introspection.report(Step.RESPONSE_SENT, who, response=response)
        self._end(
            who,
            query,
            lambda latest: latest.reply(
                self._key, payload, encoding=self._encoding, attachment=facts or None
            ),
        )

    def _refuse(self, who: bytes, query: zenoh.Query, error: Exception) -> None:
        payload = pack_error(error)
        self._end(who, query, lambda latest: latest.reply_err(payload, encoding=ENCODING))

    def _end(self, who: bytes, query: zenoh.Query, send: Callable[[zenoh.Query], None]) -> None:
        def reply(query: zenoh.Query) -> None:
            try:
                send(query)
            except zenoh.ZError:
                # Shut down while the callback ran: the caller learns that this server is gone.
                if not self._context.is_closed:
                    raise
            finally:
                query.drop()  # tells the caller that nothing else will come

        reply(self._repetitions.end(who, query, reply) if who else query)

    def destroy(self) -> None:
        """Serve no more, and let requests that wait fail; may be called twice."""
        if self._is_destroyed:
            return
        self._is_destroyed = True
        self.end_introspection()
        if not self._context.is_closed:
            self._liveliness.undeclare()
            self._queryable.undeclare()
        self._drop_queries()

    def _drop_queries(self) -> None:
        while (taken := self.take()) is not None:
            taken[0].drop()  # its caller learns that there is no answer


@dataclass(frozen=True)
class RequestHeader:
    """Which request it is that a program took itself, and when it was sent and taken."""

    query: zenoh.Query
    source_timestamp: int  #: nanoseconds since the epoch by the caller's clock; 0 if not told
    received_timestamp: int = field(default_factory=time.time_ns)  #: by this machine's clock


class ServiceHandle(Handle[Service[Any, Any]]):
    """A service's handle."""

    def service_take_request(
        self,
        request_type: object = None,  # noqa: ARG002 - rclpy's signature
    ) -> tuple[Any, RequestHeader] | tuple[None, None]:
        """Take the oldest request past the callback; two `None` if there is none."""
        return self.entity.take_request() or (None, None)

    def service_send_response(self, response: Any, header: RequestHeader) -> None:
        """Answer a request that was taken so."""
        self.entity.send_response(response, header)


def _sender(query: zenoh.Query) -> bytes:
    """A request's number and its client's gid, or nothing if they were not sent."""
    attachment = query.attachment
    facts = b"" if attachment is None else attachment.to_bytes()
    return facts[: _NUMBER.size] + facts[-GID_LENGTH:] if len(facts) == LAYOUT.size else b""


def _number(sender: bytes) -> int:
    number: int = _NUMBER.unpack_from(sender)[0]
    return number
