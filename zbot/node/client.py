"""Clients that call a service and give the response to a future or to the caller.

Zenoh's thread gives a response to the thread that waits in `call`, or to `call_async`'s future.
So `call` needs no executor. The executor runs a future's callbacks, as it runs all other callbacks.
"""

from __future__ import annotations

import threading
import time
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar, cast

import zenoh

from zbot.errors import InvalidHandleError
from zbot.interfaces import type_name
from zbot.interfaces.same_type import is_message_of
from zbot.log import get_logger
from zbot.memory import LARGE_BYTES, keep_freed_memory
from zbot.names import ACTION_PART
from zbot.node.blocking_call import wait_for_reply
from zbot.node.errors import ServiceError, request_type_error
from zbot.node.pending_calls import PendingCalls, ResponseFuture
from zbot.node.service_introspection import ServiceEndpoint, Step
from zbot.node.service_request import ServiceRequest, response_sample
from zbot.process import signals
from zbot.threads.deadline import Deadline
from zbot.threads.foreign_call import without_interruption
from zbot.threads.handle import Handle
from zbot.threads.wakeup import BinarySemaphore, BusyWait, activity
from zbot.time import as_seconds
from zbot.wire.attachment import GID_LENGTH, LAYOUT
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.context import Context
    from zbot.executor.callback_group import CallbackGroup
    from zbot.executor.ready_queue import ReadyQueue
    from zbot.executor.task import Future
    from zbot.time import Duration
    from zbot.wire.tokens import EndpointToken

RequestT = TypeVar("RequestT")
ResponseT = TypeVar("ResponseT")

_QUIET_S = 5.0  # a log line tells of a wait that is longer


class Client(ServiceEndpoint, Generic[RequestT, ResponseT]):
    """Calls a service. `Node.create_client` creates clients.

    All methods may be called from any thread.

    Args:
        context: The context whose session sends the requests.
        srv_type: Service class.
        token: The client's liveliness token: its node, service, type and profile.
        ready_queue: The queue that the node's executor takes ready entities from.
        callback_group: Decides which other callbacks may run at the same time as the callbacks of
            futures.
        logger_name: Name of the node's logger.
        is_announced: Whether the graph shows the client.
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
        is_announced: bool = True,
    ) -> None:
        self.srv_type = srv_type
        self.srv_name = token.name
        self.callback_group = callback_group
        self.ready_queue = ready_queue
        self._context = context
        self._token = token
        self._logger_name = logger_name
        dialect = context.dialect
        self._encode: Callable[[Any], Any] = dialect.codec_for(srv_type.Request).encode
        self._decode: Callable[[Any], ResponseT] = dialect.codec_for(srv_type.Response).decode
        self._encoding = zenoh.Encoding(dialect.encoding(type_name(srv_type.Request)))
        self._timeout_s = dialect.request_timeout_s(token.name)
        self._gid = token.gid
        self._next_number = context.graph.numbers.message_numbers(token)
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._calls: PendingCalls[ResponseT] = PendingCalls(
            *(self._read, lambda: context.is_closed, ready_queue),
            post=partial(ready_queue.post, self),
        )
        #: Returns the oldest completed call whose callbacks have not run, or `None`.
        self.take: Callable[[], ResponseFuture[ResponseT] | None] = self._calls.take
        self._arrival = BinarySemaphore()
        self.busy_wait = BusyWait()  #: for the threads that wait in `call`
        self._has_warned = False  #: whether a missing server was logged
        self._listener: Any = None
        self._target = (
            zenoh.QueryTarget.ALL_COMPLETE
            if dialect.calls_all_servers
            else zenoh.QueryTarget.BEST_MATCHING
        )
        self._querier: Any = context.session.declare_querier(
            dialect.data_key(token), target=self._target
        )
        self._key = self._querier.key_expr
        self._announcement = context.graph.announce(token, is_visible=is_announced)

    @property
    def handle(self) -> ClientHandle:
        """A handle for a `WaitSet`. The handle can also send requests and take responses."""
        return ClientHandle(self)

    @property
    def is_destroyed(self) -> bool:
        """Whether the client was destroyed."""
        return self._querier is None

    def service_is_ready(self) -> bool:
        """Return whether a call would reach a server."""
        with self._lock:  # Zenoh cannot undeclare a querier while another thread uses it
            querier = self._querier
            return (
                querier is not None
                and not self._context.is_closed
                and bool(querier.matching_status.matching)
            )

    def wait_for_service(self, timeout_sec: float | Duration | None = None) -> bool:
        """Wait for a server.

        Args:
            timeout_sec: Seconds to wait, or a `Duration`. With `None`, only the context's shutdown
                limits the wait. With a negative number, do not wait.

        Returns:
            Whether a server is ready.

        Raises:
            InvalidHandleError: The client or its node was destroyed.
            ArgumentTypeError: `timeout_sec` is neither a number nor a `Duration`.
            ExternalShutdownException: The main thread waits again after SIGTERM, without a call of
                `ok()`.
        """
        if not self._context.is_running:
            signals.note_vain_wait()
        if self._context.is_inherited:
            self._context.require_valid(f"the client of {self.service_name}")
        try:
            self._listen()
        except zenoh.ZError:
            if not self._context.is_closed:
                raise
        # In a node, the diagnostics warn if a server has another definition of the service. A tool
        # has no diagnostics, so the warning is logged here.
        if self._context.is_tool and not self.service_is_ready() and (text := self._other_type()):
            get_logger(self._logger_name).warning(text)
        deadline = Deadline(as_seconds("timeout_sec", timeout_sec))
        quiet = Deadline(None if self._context.is_tool else _QUIET_S)
        while not (self.is_destroyed or self.service_is_ready()) and self._context.is_running:
            if deadline.is_over:
                return False
            if quiet.is_over:
                quiet = Deadline(None)
                name = self.service_name.partition(ACTION_PART)[0]
                get_logger(self._logger_name).info(f"waiting for {name}: no server is running")
            self._arrival.wait(min(deadline.left_s, quiet.left_s))
        return self.service_is_ready()

    def _listen(self) -> None:
        with self._lock:
            if self._querier is None:
                raise InvalidHandleError(f"the client of {self.service_name}")
            if self._listener is None:
                receive = self._context.receiver(self._on_match)
                self._listener = without_interruption(
                    self._querier.declare_matching_listener, receive
                )
                self._context.add_waker(self._arrival.set)

    def _on_match(self, _: object) -> None:
        self._arrival.set()

    def call_async(self, request: RequestT) -> Future[ResponseT]:
        """Send a request.

        The first call waits until the session has discovered the servers that are already running.
        This takes at most 0.5 s and usually 2 ms.

        As in rclpy, a request without a server is lost, also if a server starts later: its future
        is never done. The client's first such request logs a warning.

        Returns:
            A future of the response. Its exception is a `ServiceError` if the server ends before it
            responds, or if the server's callback raised an exception.

        Raises:
            WrongTypeError: The argument is not a request of this service.
            CodecError: A field of the request has a wrong value.
            InvalidHandleError: The client or its node was destroyed.
            NotInitializedError: The context was shut down.
        """
        response, error = self._try_to_send(request)
        if error is not None:
            self._calls.add(response)
            if not self._has_warned:
                self._has_warned = True
                get_logger(self._logger_name).warning(f"this call gets no response: {error}")
        return response

    def call_server_async(self, request: RequestT) -> Future[ResponseT]:
        """Send a request as in `call_async`. If there is no server, the future fails immediately.

        Returns:
            A future as that of `call_async`. Its exception is a `ServiceError` with the kind
            `no_server` if there is no server.
        """
        response, error = self._try_to_send(request)
        if error is not None:
            response.set_exception(error)
        return response

    def _try_to_send(
        self, request: RequestT
    ) -> tuple[ResponseFuture[ResponseT], ServiceError | None]:
        """Send a request. Return its future, and an error if there is no server."""
        prepared = self._prepare(request)
        response: ResponseFuture[ResponseT] = ResponseFuture(self._calls, prepared, self.send)
        try:
            self._check_server()
        except ServiceError as error:
            return response, error
        self._calls.add(response)
        if self._introspection is not None:
            self._introspection.report(Step.REQUEST_SENT, prepared.attachment, request=request)
        response.send()
        return response, None

    def call(self, request: RequestT, timeout_sec: float | None = None) -> ResponseT:
        """Send a request and wait for the response.

        Any thread may call this, also in a callback, because the wait needs no executor. A callback
        may also call a server that is in the same executor: during the wait, the calling thread
        runs the server's callback.

        Args:
            request: The request.
            timeout_sec: Seconds to wait. With 0 or a negative number, do not wait. `None` means no
                limit, but the call still fails if the server ends.

        Raises:
            ServiceError: There is no server, it ended before it responded, or its callback raised
                an exception.
            TimeoutError: No response came within `timeout_sec`.
            NotInitializedError: The context was shut down during the wait.
        """
        prepared = self._prepare(request)
        self._check_server()
        if self._introspection is not None:
            self._introspection.report(Step.REQUEST_SENT, prepared.attachment, request=request)
        reply = wait_for_reply(self, prepared, timeout_sec)
        return self._read(reply)

    def _prepare(self, request: RequestT) -> ServiceRequest:
        expected = self.srv_type.Request
        if request.__class__ is not expected and not is_message_of(request, expected):
            raise request_type_error(self.service_name, expected, request)
        payload = self._encode(request)
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
            payload = self._context.share(payload)
        with self._lock:
            number = self._next_number()
        attachment = LAYOUT.pack(number, time.time_ns(), GID_LENGTH, self._gid)
        return ServiceRequest(payload, attachment, timeout_s=self._timeout_s)

    def _check_server(self) -> None:
        if self.service_is_ready():
            return
        if self._querier is None:
            raise InvalidHandleError(f"the client of {self.service_name}")
        if self._context.is_closed:
            self._context.require_valid(f"the client of {self.service_name}")
            signals.raise_not_initialized("a service call")
        self._context.wait_for_peers()
        if not self.service_is_ready():
            reason = "no server is running; start it, or wait for it with wait_for_service()"
            raise ServiceError(self.service_name, "no_server", self._other_type() or reason)

    def _other_type(self) -> str:
        """Return a sentence about a server with another definition, or an empty string."""
        if not self._context.dialect.needs_equal_types:
            return ""
        for server in self._context.graph.query().on(self.service_name, EntityKind.SERVICE):
            is_same_type = server.type_name == self._token.type_name
            if is_same_type and server.type_hash != self._token.type_hash:
                from zbot.node.type_difference import difference_text  # noqa: PLC0415 - rarely needed

                return difference_text(self._context, self._token, server)
        return ""

    def send(
        self,
        request: ServiceRequest,
        on_reply: Callable[[zenoh.Reply], object],
        on_end: Callable[[], object],
    ) -> None:
        """Send a request. Zenoh's thread calls `on_reply` for each reply, then `on_end` once.

        Raises:
            InvalidHandleError: The client was destroyed, also while it waited for a response.
            NotInitializedError: The context was shut down.
        """
        if self._querier is None:
            raise InvalidHandleError(f"the client of {self.service_name}")
        handler: Any = zenoh.handlers.Callback(on_reply, drop=on_end, indirect=False)
        activity.has_sent = True
        with self._context.until_shutdown("a service call"):
            self._context.session.get(
                self._key,
                handler,
                payload=request.payload,
                encoding=self._encoding,
                attachment=request.attachment,
                target=self._target,
                consolidation=zenoh.ConsolidationMode.NONE,
                timeout=request.timeout_s,
            )

    def remove_pending_request(self, future: Future[ResponseT]) -> None:
        """Forget a call and never complete its future. Nothing happens if the call is over."""
        self._calls.forget(future)

    def get_pending_request(self, sequence_number: int) -> Future[ResponseT]:
        """Return the future of the call with a number, which is usually 1 for the first call.

        Raises:
            KeyError: There is no such call, or it is over.
        """
        return self._calls.with_number(sequence_number)

    def _read(self, reply: zenoh.Reply | None) -> ResponseT:
        sample = response_sample(reply, self.service_name)
        payload = sample.payload.to_bytes()
        if len(payload) >= LARGE_BYTES:
            keep_freed_memory()
        response = self._decode(payload)
        if self._introspection is not None:
            attachment = sample.attachment
            call = b"" if attachment is None else attachment.to_bytes()
            self._introspection.report(Step.RESPONSE_RECEIVED, call, response=response)
        return response

    @property
    def on_response(self) -> Callable[[int], object] | None:
        """This function is called for each response. It must return quickly."""
        return self._calls.on_response

    @on_response.setter
    def on_response(self, callback: Callable[[int], object] | None) -> None:
        self._calls.on_response = callback

    @property
    def has_work(self) -> bool:
        """Whether there is a completed call whose callbacks have not run."""
        return bool(self._calls)

    def execute(self, response: ResponseFuture[ResponseT]) -> None:
        """Run the callbacks of a call's future."""
        response.run_callbacks(self.ready_queue.executor)

    def destroy(self) -> None:
        """Leave the graph and forget the waiting calls. This method may be called twice."""
        with self._lock:
            querier, self._querier = self._querier, None
            self._calls.clear()
        if querier is None:
            return
        self._context.remove_waker(self._arrival.set)
        self._arrival.set()
        self.end_introspection()
        listener = () if self._listener is None else (self._listener,)
        self._context.undeclare(self._announcement, *listener, querier)


class ResponseHeader(NamedTuple):
    """Header of a response that a program took without an executor."""

    sequence_number: int  #: the number that `send_request` returned

    @property
    def request_id(self) -> ResponseHeader:
        """What has the attribute `sequence_number` in rclpy."""
        return self


class ClientHandle(Handle[Client[Any, Any]]):
    """A client's handle."""

    def service_server_is_available(self) -> bool:
        """Return whether a call would reach a server."""
        return self.entity.service_is_ready()

    def send_request(self, request: Any) -> int:
        """Send a request and return its number."""
        return cast("ResponseFuture[Any]", self.entity.call_async(request)).number

    def take_response(
        self,
        response_type: object = None,  # noqa: ARG002 - rclpy's signature
    ) -> tuple[ResponseHeader, Any] | tuple[None, None]:
        """Take the oldest response. If there is no response, return `(None, None)`.

        A request that was sent without a server gets no response.

        Raises:
            ServiceError: The server ended before it responded, or its callback raised an exception.
        """
        response = self.entity.take()
        if response is None:
            return None, None
        return ResponseHeader(response.number), response.result()

    def set_on_new_response_callback(self, callback: Callable[[int], object]) -> None:
        """Set a function that is called with the number of new responses.

        The thread that receives the responses calls the function, which must return quickly.
        """
        self.entity.on_response = callback

    def clear_on_new_response_callback(self) -> None:
        """Remove the callback for new responses."""
        self.entity.on_response = None
