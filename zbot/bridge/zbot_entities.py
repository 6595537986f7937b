"""Endpoints of a bridge on the side of zbot. They send and receive bytes as they are."""

from __future__ import annotations

import itertools
import threading
import time
from typing import TYPE_CHECKING, Any

import zenoh

from zbot.bridge.errors import CallError
from zbot.errors import InvalidHandleError
from zbot.executor.callback_group import ReentrantCallbackGroup
from zbot.memory import LARGE_BYTES, keep_freed_memory
from zbot.node.client import Client
from zbot.node.publisher import Publisher
from zbot.node.service import Service, request_id_of
from zbot.node.service_request import ServiceRequest
from zbot.node.subscription import Subscription
from zbot.threads.foreign_call import called_by_zenoh
from zbot.wire.attachment import GID_LENGTH, LAYOUT
from zbot.wire.error_reply import ENCODING, unpack_error
from zbot.wire.messagepack.packing import pack

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.bridge.side import Answer
    from zbot.node.node import Node
    from zbot.wire.tokens import EndpointToken

#: First bytes of the id of a bridge's publisher. Bridges do not carry messages with such an id.
BRIDGE_MARK = b"zbridge\0"


class RawPublisher(Publisher[Any]):
    """Publisher of bytes that are in the format of the context's dialect."""

    def __init__(self, node: Node, message_class: type[Any], token: EndpointToken) -> None:
        self._node = node
        super().__init__(
            node.context,
            message_class,
            token,
            logger_name=node.handle.logger_name,
            callback_group=node.default_callback_group,
            is_announced=False,
        )
        self._gid = BRIDGE_MARK + token.gid[len(BRIDGE_MARK) :]

    def send(self, data: bytes) -> None:
        """Publish a message. Do nothing if the publisher or its context was closed."""
        payload: Any = data
        if len(data) >= LARGE_BYTES:
            keep_freed_memory()
            if not self._is_latched:
                payload = self._context.share(data)
        try:
            self._send_locked(payload)
        except (zenoh.ZError, InvalidHandleError):
            if self.is_open:
                raise

    def close(self) -> None:
        """Leave the topic."""
        self.destroy()


class RawSubscription:
    """Subscription that receives messages as bytes, in the format of the context's dialect."""

    def __init__(
        self,
        node: Node,
        message_class: type[Any],
        token: EndpointToken,
        receive: Callable[[bytes, Any], None],
    ) -> None:
        self._handle = node.handle
        self.entity: Subscription[Any] = Subscription(
            node.context,
            message_class,
            receive,
            token,
            ready_queue=self._handle.ready_queue,
            callback_group=node.default_callback_group,
            raw="payload",
            logger_name=self._handle.logger_name,
            is_announced=False,
        )
        self._handle.subscriptions.append(self.entity)
        self._handle.add(self.entity)
        self.entity.start()

    def close(self) -> None:
        """Leave the topic."""
        if self.entity in self._handle.subscriptions:
            self._handle.subscriptions.remove(self.entity)
        self._handle.ready_queue.remove(self.entity)
        self.entity.destroy()


class RawServer(Service[bytes, bytes]):
    """Server that passes the bytes of each request on. Zenoh's thread calls `serve`."""

    def __init__(
        self,
        node: Node,
        service_class: type[Any],
        token: EndpointToken,
        serve: Callable[[bytes, Answer], None],
        admits: Callable[[bytes], bool] | None = None,
    ) -> None:
        self._serve, self._admits = serve, admits
        super().__init__(
            node.context,
            service_class,
            _no_callback,
            token,
            ready_queue=node.handle.ready_queue,
            callback_group=ReentrantCallbackGroup(),
            logger_name=node.handle.logger_name,
        )
        self._handle = node.handle
        self._handle.services.append(self)
        self._handle.add(self)

    def execute(self, taken: tuple[zenoh.Query, float]) -> None:
        """Pass a request on."""
        query, arrived_s = taken
        request_id = request_id_of(query)
        if request_id and not self._repeated.is_new(request_id, query, arrived_s):
            return
        if self._admits is not None and not self._admits(request_id[-GID_LENGTH:]):
            reason = "it is not your turn: the teacher gives the robot with `zbot class give`"
            self.fail(request_id, query, CallError("not_driving", reason))
            return
        payload = b"" if query.payload is None else query.payload.to_bytes()
        self._serve(payload, _ZenohAnswer(self, request_id, query))

    def reply(self, request_id: bytes, query: zenoh.Query, data: bytes) -> None:
        """Send a response."""
        self._reply_payload(request_id, query, data)

    def fail(self, request_id: bytes, query: zenoh.Query, error: CallError) -> None:
        """Send an error."""
        payload, encoding = self._context.dialect.error_payload(error)
        if encoding == ENCODING:
            payload = pack({"error": error.kind, "message": error.message})
        self._send_reply(
            request_id,
            query,
            lambda latest: latest.reply_err(payload, encoding=encoding),
            len(payload),
        )

    def close(self) -> None:
        """Stop offering the service."""
        if self in self._handle.services:
            self._handle.services.remove(self)
        self._handle.ready_queue.remove(self)
        self.destroy()


class _ZenohAnswer:
    """Answer to a request that came over Zenoh."""

    def __init__(self, server: RawServer, request_id: bytes, query: zenoh.Query) -> None:
        self._server, self._request_id, self._query = server, request_id, query

    def reply(self, data: bytes) -> None:
        """Send the response."""
        self._server.reply(self._request_id, self._query, data)

    def fail(self, error: CallError) -> None:
        """Let the call fail."""
        self._server.fail(self._request_id, self._query, error)


def _no_callback(request: bytes, response: bytes) -> bytes:
    raise AssertionError((request, response))  # `execute` is replaced


class RawCaller:
    """Client that sends the bytes of requests, and passes on the bytes of responses."""

    def __init__(self, node: Node, service_class: type[Any], token: EndpointToken) -> None:
        self.client: Client[Any, Any] = Client(
            node.context,
            service_class,
            token,
            ready_queue=node.handle.ready_queue,
            callback_group=node.default_callback_group,
            logger_name=node.handle.logger_name,
            is_announced=False,
        )
        self._numbers = itertools.count(1)
        self._calls: set[_Call] = set()

    def call(self, request: bytes, answer: Answer) -> None:
        """Send a request. Any thread may call this."""
        gid = self.client.token.gid
        attachment = LAYOUT.pack(next(self._numbers), time.time_ns(), GID_LENGTH, gid)
        timeout_s = self.client.context.dialect.request_timeout_s(self.client.token.name)
        call = _Call(self, ServiceRequest(request, attachment, timeout_s=timeout_s), answer)
        self._calls.add(call)
        call.send()

    def forget(self, call: _Call) -> None:
        """Forget a call that is over."""
        self._calls.discard(call)

    def close(self) -> None:
        """Leave the graph. Calls without a reply fail."""
        self.client.destroy()
        for call in list(self._calls):
            call.end(None)


class _Call:
    """Call over Zenoh that waits for its reply."""

    def __init__(self, caller: RawCaller, request: ServiceRequest, answer: Answer) -> None:
        self._caller, self._request, self._answer = caller, request, answer
        self._attempt = 0
        self._lock = threading.Lock()
        self._is_over = False

    def send(self) -> None:
        """Send the request, for the first time or again."""
        self._attempt += 1
        attempt = self._attempt

        @called_by_zenoh
        def on_end() -> None:
            if attempt == self._attempt:
                self._on_end()

        self._caller.client.send(self._request, self._on_reply, on_end)

    @called_by_zenoh
    def _on_reply(self, reply: zenoh.Reply) -> None:
        if not self._request.is_timeout(reply):
            self.end(reply)

    @called_by_zenoh
    def _on_end(self) -> None:
        is_wanted = not (self._is_over or self._caller.client.is_destroyed)
        if is_wanted and self._request.is_to_be_repeated():
            self.send()
        else:
            self.end(None)

    def end(self, reply: zenoh.Reply | None) -> None:
        """Give the reply to the answer. `None` means that no reply came."""
        with self._lock:
            if self._is_over:
                return
            self._is_over = True
        self._caller.forget(self)
        if reply is not None and reply.ok is not None:
            self._answer.reply(reply.ok.payload.to_bytes())
        elif reply is not None and reply.err is not None:
            self._answer.fail(CallError(*unpack_error(reply.err.payload.to_bytes())))
        else:
            self._answer.fail(CallError("server_gone", "the server ended before it answered"))
