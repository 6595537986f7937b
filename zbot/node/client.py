"""Clients: they call a service, and a future or the caller gets its response.

Zenoh's thread decodes a response and completes its future there and then, so that `call` works
wherever a thread can wait. The future's callbacks are the executor's work like all others.
"""

from __future__ import annotations

import contextlib
import inspect
import threading
import time
from collections import deque
from functools import partial
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar, cast

import zenoh

from zbot.errors import InvalidHandleError, NotInitializedError
from zbot.executor.callback_stack import callbacks, current_executor
from zbot.executor.task import Future
from zbot.interfaces import type_name
from zbot.node.errors import RequestTypeError, ServiceError
from zbot.node.service_introspection import ServiceEndpoint, Step
from zbot.process.memory import LARGE_BYTES, keep_freed_memory
from zbot.transport.foreign_call import called_by_zenoh, in_one_go, keep_thread_state
from zbot.transport.handle import Handle
from zbot.transport.wakeup import LONGEST_WAIT_S, BinarySemaphore, BusyWait
from zbot.wire.attachment import GID_LENGTH, LAYOUT
from zbot.wire.codec import CodecError
from zbot.wire.error_reply import unpack_error

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from typing_extensions import Self

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.executor import Executor
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.node.service import Service
    from zbot.wire.tokens import EndpointToken

RequestT = TypeVar("RequestT")
ResponseT = TypeVar("ResponseT")

# Zenoh keeps 0.8 kB for each query until its time is over, however soon it was answered: so its
# time is short, and a request that takes longer is repeated, at growing intervals (docs/wire.md).
_FIRST_PATIENCE_S = 2.0
_LONGEST_PATIENCE_S = 60.0
_TIME_IS_OVER = b"Timeout"  # what Zenoh itself puts in the place of a reply
_WOKEN = object()  # stands for "look around" among the replies


class _Exchange:
    """One request, as often as it has to be sent.

    Args:
        payload: The encoded request.
        facts: The attachment; a repeated request has the same, so that it is served once.
    """

    __slots__ = ("facts", "patience_s", "payload")

    def __init__(self, payload: Any, facts: bytes) -> None:
        self.payload = payload
        self.facts = facts
        self.patience_s = _FIRST_PATIENCE_S

    def is_to_be_repeated(self, reply: zenoh.Reply) -> bool:
        """Return whether a reply only says that the query's time is over."""
        if reply.ok is not None or reply.err is None:
            return False
        if reply.err.payload.to_bytes() != _TIME_IS_OVER:
            return False
        self.patience_s = min(2 * self.patience_s, _LONGEST_PATIENCE_S)
        return True


class _Response(Future[ResponseT]):
    """A call's future: its callbacks run as work of the client."""

    def __init__(self, client: Client[Any, ResponseT], exchange: _Exchange) -> None:
        super().__init__()
        self._client = client
        self._exchange = exchange
        self._attempt = 0

    @property
    def number(self) -> int:
        """The request's number, which its client counts from 1."""
        number: int = LAYOUT.unpack(self._exchange.facts)[0]
        return number

    def send(self) -> None:
        """Send the request, for the first time or again."""
        self._attempt += 1
        ended = partial(self._on_end, self._attempt)
        self._client.send(self._exchange, self._on_reply, ended)

    @called_by_zenoh
    def _on_reply(self, reply: zenoh.Reply) -> None:
        # Zenoh's thread, as below.
        keep_thread_state()
        if not self._exchange.is_to_be_repeated(reply):
            self._client.complete(self, reply)
        elif self._client.is_pending(self):
            self.send()

    @called_by_zenoh
    def _on_end(self, attempt: int) -> None:
        if attempt == self._attempt and not self.is_over:
            self._client.complete(self, None)

    @property
    def has_callbacks(self) -> bool:
        """Whether there is anything to run when it is over."""
        return bool(self._callbacks)

    def _tell(self) -> None:
        # Even without callbacks: `spin_once` returns when a response has come.
        self._client.post(self)

    def add_done_callback(self, callback: Callable[[Self], Any]) -> None:
        """Call `callback(self)` in the node's executor when done, soon if it is."""
        with self._lock:
            self._callbacks.append(callback)
            if not self.is_over:
                return
        self._client.post(self)

    def pop_callbacks(self) -> list[Callable[[Any], Any]]:
        """Return the callbacks that are due, and forget them."""
        return self._pop_callbacks()


class Client(ServiceEndpoint, Generic[RequestT, ResponseT]):
    """Calls a service. Made by `Node.create_client`; all methods may be called from any thread.

    Args:
        context: The session to call through.
        srv_type: Service class.
        token: Who and where this client is.
        ready_queue: The node's way to its executor.
        callback_group: Decides beside what the callbacks of its futures may run.
        logger_name: The node's logger.
    """

    due_ns: int | None = None

    def __init__(
        self,
        context: Context,
        srv_type: type[Any],
        token: EndpointToken,
        *,
        ready_queue: ReadyQueue,
        callback_group: CallbackGroup,
        logger_name: str,
    ) -> None:
        self.srv_type = srv_type
        self.srv_name = token.name
        self.callback_group = callback_group
        self.ready_queue = ready_queue
        self.on_response: Callable[[int], object] | None = None  #: told of each response; be quick
        self._context = context
        self._token = token
        self._logger_name = logger_name
        dialect = context.dialect
        self._encode: Callable[[Any], Any] = dialect.codec_for(srv_type.Request).encode
        self._decode: Callable[[Any], ResponseT] = dialect.codec_for(srv_type.Response).decode
        self._encoding = zenoh.Encoding(dialect.encoding(type_name(srv_type.Request)))
        self._gid = token.gid
        self._sent_count = 0
        self._lock = threading.RLock()  # re-entrant, for a signal's handler
        self._pending: dict[_Response[ResponseT], int] = {}
        self._completed: deque[_Response[ResponseT]] = deque()
        self._arrival = BinarySemaphore()
        self._busy_wait = BusyWait()
        self._listener: Any = None
        self._querier: Any = context.session.declare_querier(
            dialect.topic_key(context.get_domain_id(), token.name)
        )
        self._liveliness = context.graph.announce(token)

    @property
    def handle(self) -> ClientHandle:
        """What a `WaitSet` takes, and what responses can be taken from without an executor."""
        return ClientHandle(self)

    @property
    def is_destroyed(self) -> bool:
        """Whether it calls no more."""
        return self._querier is None

    # -- is there a server? --------------------------------------------------------------------

    def service_is_ready(self) -> bool:
        """Return whether there is a server that a call would reach."""
        querier = self._querier
        return (
            querier is not None
            and not self._context.is_closed
            and bool(querier.matching_status.matching)
        )

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server.

        Args:
            timeout_sec: Seconds; `None` or less than 0 for as long as the context lives.

        Returns:
            Whether there is one.

        Raises:
            InvalidHandleError: The client or its node was destroyed.
        """
        self._listen()
        endless = timeout_sec is None or timeout_sec < 0
        deadline = time.monotonic() + (0 if endless or timeout_sec is None else timeout_sec)
        while not self.service_is_ready() and self._context.ok():
            left = threading.TIMEOUT_MAX if endless else deadline - time.monotonic()
            if left <= 0:
                return False
            self._arrival.wait(left)
        return self.service_is_ready()

    def _listen(self) -> None:
        with self._lock:
            if self._querier is None:
                raise InvalidHandleError(f"the client of {self.service_name}")
            if self._listener is None:
                receive = self._context.receiver(self._on_match)
                self._listener = in_one_go(self._querier.declare_matching_listener, receive)
                self._context.add_waker(self._arrival.set)

    def _on_match(self, _: object) -> None:
        self._arrival.set()

    # -- calling -------------------------------------------------------------------------------

    def call_async(self, request: RequestT) -> Future[ResponseT]:
        """Send a request.

        The first call waits, at most 0.5 s and usually 2 ms, until the session has met the servers
        that are there.

        Returns:
            A future of the response. It has a `ServiceError` if there is no server, if the server
            ends before it answers, or if its callback raised.

        Raises:
            RequestTypeError: It is no request of this service.
            FieldTypeError: A field of it was given a wrong value behind its checks.
            InvalidHandleError: The client or its node was destroyed.
            NotInitializedError: The context was shut down.
        """
        exchange = self._prepare(request)
        response: _Response[ResponseT] = _Response(self, exchange)
        try:
            self._check_server()
        except ServiceError as error:
            response.set_exception(error)
            return response
        with self._lock:
            self._pending[response] = self._sent_count
        if self._introspection is not None:
            self._introspection.report(Step.REQUEST_SENT, exchange.facts, request=request)
        response.send()
        return response

    def call(self, request: RequestT, timeout_sec: float | None = None) -> ResponseT:
        """Send a request and wait for the response.

        It may be called anywhere, also in a callback: what it waits for needs no executor, and if
        the service is served by the very thread that waits, it is served meanwhile.

        Args:
            request: What to send.
            timeout_sec: Seconds to wait; `None` for as long as the server lives.

        Raises:
            ServiceError: See `call_async`.
            TimeoutError: There was no response in time.
            NotInitializedError: The context was shut down meanwhile.
        """
        exchange = self._prepare(request)
        self._check_server()
        if self._introspection is not None:
            self._introspection.report(Step.REQUEST_SENT, exchange.facts, request=request)
        # Zenoh's thread puts each reply, and the attempt's number at its end: a function written in
        # Python would cost it 20 us each time, to make room for a frame in that thread.
        arrivals: SimpleQueue[Any] = SimpleQueue()
        executor = current_executor()
        own = [] if executor is None else self._served_by(executor)
        deadline = (
            None if timeout_sec is None or timeout_sec < 0 else time.monotonic() + timeout_sec
        )
        with self._waking(partial(arrivals.put, _WOKEN), own):
            attempt = 0
            while True:
                self.send(exchange, arrivals.put, partial(arrivals.put, attempt))
                reply = self._wait(arrivals, attempt, deadline, lambda: self._serve(executor, own))
                if reply is None or not exchange.is_to_be_repeated(reply):
                    break
                attempt += 1
        return self._read(reply)

    @contextlib.contextmanager
    def _waking(self, wake: Callable[[], None], own: list[Service[Any, Any]]) -> Iterator[None]:
        self._context.add_waker(wake)
        for service in own:
            service.watchers.append(wake)
        try:
            yield
        finally:
            self._context.remove_waker(wake)
            for service in own:
                service.watchers.remove(wake)

    def _wait(
        self,
        arrivals: SimpleQueue[Any],
        attempt: int,
        deadline: float | None,
        serve: Callable[[], bool],
    ) -> zenoh.Reply | None:
        while True:
            while serve():
                pass
            left = LONGEST_WAIT_S if deadline is None else deadline - time.monotonic()
            self._busy_wait.begin(arrivals.qsize)
            try:
                arrived = arrivals.get(timeout=max(0.0, min(left, LONGEST_WAIT_S)))
            except Empty:
                if left <= 0:
                    sentence = f"{self.service_name}: there was no response in time"
                    raise TimeoutError(sentence) from None
                continue
            self._busy_wait.end(came=True)
            if arrived == attempt:
                return None
            if arrived is _WOKEN:
                if self._context.is_over:
                    raise NotInitializedError("a service call")
            elif not isinstance(arrived, int):
                return cast("zenoh.Reply", arrived)

    def _served_by(self, executor: Executor) -> list[Service[Any, Any]]:
        return [
            service
            for node in executor.get_nodes()
            for service in node.handle.services
            if service.service_name == self.service_name
        ]

    @staticmethod
    def _serve(executor: Executor | None, own: list[Service[Any, Any]]) -> bool:
        """Run a request that waits for this very thread; return whether there was one."""
        if executor is None:
            return False
        # What a callback raises reaches its caller in the reply, and its caller is this one.
        with contextlib.suppress(Exception):
            return any(executor.serve(service) for service in own)
        return True

    def _prepare(self, request: RequestT) -> _Exchange:
        expected = self.srv_type.Request
        if request.__class__ is not expected and not isinstance(request, expected):
            raise RequestTypeError(self.service_name, type_name(expected), request)
        payload = self._encode(request)
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            payload = self._context.share(payload)
        with self._lock:
            self._sent_count += 1
            facts = LAYOUT.pack(self._sent_count, time.time_ns(), GID_LENGTH, self._gid)
        return _Exchange(payload, facts)

    def _check_server(self) -> None:
        if self.service_is_ready():
            return
        if self._querier is None:
            raise InvalidHandleError(f"the client of {self.service_name}")
        if self._context.is_closed:
            raise NotInitializedError("a service call")
        self._context.meet()
        if not self.service_is_ready():
            what = "no server is running; start it, or wait for it with wait_for_service()"
            raise ServiceError(self.service_name, "no_server", what)

    def send(
        self,
        exchange: _Exchange,
        on_reply: Callable[[zenoh.Reply], object],
        on_end: Callable[[], object],
    ) -> None:
        """Send a request; Zenoh's thread calls `on_reply` for each reply, and `on_end` last."""
        answer: Any = zenoh.handlers.Callback(on_reply, drop=on_end, indirect=False)
        self._context.session.get(
            self._querier.key_expr,
            answer,
            payload=exchange.payload,
            encoding=self._encoding,
            attachment=exchange.facts,
            consolidation=zenoh.ConsolidationMode.NONE,
            timeout=exchange.patience_s,
        )

    def is_pending(self, response: _Response[ResponseT]) -> bool:
        """Return whether somebody still waits for a response."""
        return response in self._pending and not self._context.is_closed

    def remove_pending_request(self, future: Future[ResponseT]) -> None:
        """Forget a call: its future is never completed. Nothing happens if it is over."""
        with self._lock:
            self._pending.pop(cast("_Response[ResponseT]", future), None)

    def get_pending_request(self, sequence_number: int) -> Future[ResponseT]:
        """Return the future of a call by the call's number, from 1.

        Raises:
            KeyError: There is none, or it is over.
        """
        with self._lock:
            for future, number in self._pending.items():
                if number == sequence_number:
                    return future
        raise KeyError(f"no pending request with number {sequence_number}")

    # -- answers -------------------------------------------------------------------------------

    def complete(self, response: _Response[ResponseT], reply: zenoh.Reply | None) -> None:
        """Give a call's future what came for it; in Zenoh's thread, or the server's own."""
        with self._lock:
            if self._pending.pop(response, None) is None:
                return  # nobody waits any more
        executor = current_executor()
        if reply is not None and executor is not None and executor is self.ready_queue.executor:
            # The server's callback may have more to do: who spins until then sees it done.
            callbacks.at_end(partial(self._finish, response, reply))
        else:
            self._finish(response, reply)

    def _finish(self, response: _Response[ResponseT], reply: zenoh.Reply | None) -> None:
        try:
            response.set_result(self._read(reply))
        except (ServiceError, CodecError) as error:
            response.set_exception(error)
        if self.on_response is not None:
            self.on_response(1)

    def _read(self, reply: zenoh.Reply | None) -> ResponseT:
        if reply is None:
            raise ServiceError(
                self.service_name, "server_gone", "the server ended before it answered"
            )
        if reply.ok is None:
            error = reply.err
            payload = b"" if error is None else error.payload.to_bytes()
            raise ServiceError(self.service_name, *unpack_error(payload))
        payload = reply.ok.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
        response = self._decode(payload)
        if self._introspection is not None:
            facts = reply.ok.attachment
            call = b"" if facts is None else facts.to_bytes()
            self._introspection.report(Step.RESPONSE_RECEIVED, call, response=response)
        return response

    def post(self, response: _Response[ResponseT]) -> None:
        """Let the executor run what waits for a response; from any thread."""
        # Where nothing is to be run one is enough to let `spin_once` return. Who spins only until
        # its own call is over, and serves it too, would never take the others.
        if response.has_callbacks or not self._completed:
            self._completed.append(response)
        self.ready_queue.post(self)

    @property
    def has_work(self) -> bool:
        """Whether a call is over whose callbacks have not run."""
        return bool(self._completed)

    def take(self) -> _Response[ResponseT] | None:
        """Return a call that is over and whose callbacks have not run."""
        try:
            return self._completed.popleft()
        except IndexError:
            return None

    def execute(self, response: _Response[ResponseT]) -> None:
        """Run the callbacks of a call's future."""
        for callback in response.pop_callbacks():
            outcome = callback(response)
            executor: Any = self.ready_queue.executor
            if inspect.iscoroutine(outcome) and executor is not None:
                executor.create_task(outcome)

    def destroy(self) -> None:
        """Call no more; calls that wait for an answer are forgotten; may be called twice."""
        with self._lock:
            querier, self._querier = self._querier, None
            self._pending.clear()
        if querier is None:
            return
        self._context.remove_waker(self._arrival.set)
        self._arrival.set()
        self.end_introspection()
        if not self._context.is_closed:
            self._liveliness.undeclare()
            if self._listener is not None:
                self._listener.undeclare()
            querier.undeclare()


class ResponseHeader(NamedTuple):
    """Which request it is whose response a program took itself."""

    sequence_number: int  #: what `send_request` returned


class ClientHandle(Handle[Client[Any, Any]]):
    """A client's handle."""

    def service_server_is_available(self) -> bool:
        """Return whether a server is there."""
        return self.entity.service_is_ready()

    def send_request(self, request: Any) -> int:
        """Send a request; return its number."""
        return cast("_Response[Any]", self.entity.call_async(request)).number

    def take_response(
        self,
        response_type: object = None,  # noqa: ARG002 - rclpy's signature
    ) -> tuple[ResponseHeader, Any] | tuple[None, None]:
        """Take the oldest response; two `None` if there is none.

        Raises:
            ServiceError: The call failed, or there was no server.
        """
        response = self.entity.take()
        if response is None:
            return None, None
        return ResponseHeader(response.number), response.result()

    def set_on_new_response_callback(self, callback: Callable[[int], object]) -> None:
        """Call a quick function with the number of new responses, in the thread they come in."""
        self.entity.on_response = callback

    def clear_on_new_response_callback(self) -> None:
        """Call it no more."""
        self.entity.on_response = None
