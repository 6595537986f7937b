"""Calls of a client that wait for their responses, and the futures of these responses.

Zenoh's thread completes a call. The executor runs the callbacks of its future.
"""

from __future__ import annotations

import inspect
import threading
from collections import deque
from functools import partial
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from zbot.executor.callback_check import check_callback
from zbot.executor.callback_stack import current_executor, running_callbacks
from zbot.executor.task import Future
from zbot.node.errors import ServiceError
from zbot.threads.foreign_call import called_by_zenoh, keep_thread_state
from zbot.wire.attachment import LAYOUT
from zbot.wire.errors import CodecError

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh
    from typing_extensions import Self

    from zbot.executor.ready_queue import ReadyQueue
    from zbot.node.service_request import ServiceRequest

    #: Sends a request. The second argument is called for each reply, then the third one once.
    Send = Callable[[ServiceRequest, Callable[[zenoh.Reply], object], Callable[[], object]], None]

ResponseT = TypeVar("ResponseT")


class ResponseFuture(Future[ResponseT]):
    """Future of a response. The client's executor runs the future's callbacks.

    Args:
        calls: The calls of the client.
        request: The request.
        send: Sends the request.
    """

    def __init__(self, calls: PendingCalls[ResponseT], request: ServiceRequest, send: Send) -> None:
        super().__init__()
        self._calls = calls
        self._request = request
        self._send = send
        self._attempt = 0

    @property
    def number(self) -> int:
        """The request's number. The first request of a client has the number 1."""
        number: int = LAYOUT.unpack(self._request.attachment)[0]
        return number

    def send(self) -> None:
        """Send the request, for the first time or again."""
        self._attempt += 1
        self._send(self._request, self._on_reply, partial(self._on_end, self._attempt))

    @called_by_zenoh
    def _on_reply(self, reply: zenoh.Reply) -> None:
        keep_thread_state()
        if not self._request.is_timeout(reply):
            self._calls.complete(self, reply)

    @called_by_zenoh
    def _on_end(self, attempt: int) -> None:
        if attempt != self._attempt or self.is_over:
            return
        if not self._request.is_to_be_repeated():
            self._calls.complete(self, None)
        elif self._calls.is_pending(self):
            self.send()

    @property
    def has_callbacks(self) -> bool:
        """Whether a callback is to run when the call is over."""
        return bool(self._callbacks)

    def _run_callbacks(self) -> None:
        # The executor runs the callbacks. This call also makes a waiting `spin_once` return.
        self._calls.post(self)

    def add_done_callback(self, callback: Callable[[Self], Any]) -> None:
        """Let the executor call `callback(self)` as soon as the future is over."""
        check_callback("add_done_callback", callback, "(future)")
        with self._lock:
            self._callbacks.append(callback)
            if not self.is_over:
                return
        self._calls.post(self)

    def run_callbacks(self, executor: Any) -> None:
        """Run and forget the callbacks that have not run. Give coroutines to an executor."""
        for callback in self._pop_callbacks():
            outcome = callback(self)
            if inspect.iscoroutine(outcome) and executor is not None:
                executor.create_task(outcome)


class PendingCalls(Generic[ResponseT]):
    """Calls that wait for their responses, and completed calls whose callbacks have not run.

    Any thread may call the methods.

    Args:
        read: Returns the response in a reply, or raises the error in it. It is given `None` if the
            server ended without a reply.
        is_closed: Returns whether the session is closed.
        ready_queue: The queue of the client's node.
        post: Tells the executor that a call is complete.
    """

    def __init__(
        self,
        read: Callable[[zenoh.Reply | None], ResponseT],
        is_closed: Callable[[], bool],
        ready_queue: ReadyQueue,
        post: Callable[[], object],
    ) -> None:
        #: This function is called for each response. It must return quickly.
        self.on_response: Callable[[int], object] | None = None
        self._read = read
        self._is_closed = is_closed
        self._ready_queue = ready_queue
        self._post = post
        self._lock = threading.RLock()  # re-entrant, because a signal handler may use it
        self._numbers: dict[ResponseFuture[ResponseT], int] = {}
        self._completed: deque[ResponseFuture[ResponseT]] = deque()

    def add(self, response: ResponseFuture[ResponseT]) -> None:
        """Add a call."""
        with self._lock:
            self._numbers[response] = response.number

    def forget(self, future: Future[ResponseT]) -> bool:
        """Forget a call and never complete its future. Return whether the call was pending."""
        with self._lock:
            response = cast("ResponseFuture[ResponseT]", future)
            return self._numbers.pop(response, None) is not None

    def clear(self) -> None:
        """Forget all calls that wait for their responses."""
        with self._lock:
            self._numbers.clear()

    def is_pending(self, response: ResponseFuture[ResponseT]) -> bool:
        """Return whether a call still waits for its response."""
        return response in self._numbers and not self._is_closed()

    def with_number(self, number: int) -> ResponseFuture[ResponseT]:
        """Return the call with a number.

        Raises:
            KeyError: There is no such call, or it is over.
        """
        with self._lock:
            for response, known in self._numbers.items():
                if known == number:
                    return response
        raise KeyError(f"no pending request with number {number}")

    def complete(self, response: ResponseFuture[ResponseT], reply: zenoh.Reply | None) -> None:
        """Complete a call's future. Zenoh's thread or the thread of a local server calls this."""
        if not self.forget(response):
            return  # the call was forgotten
        executor = current_executor()
        if reply is not None and executor is not None and executor is self._ready_queue.executor:
            # The server's callback still runs in this thread. `spin_until_future_complete` must not
            # return before that callback ends.
            running_callbacks.at_end(partial(self._finish, response, reply))
        else:
            self._finish(response, reply)

    def _finish(self, response: ResponseFuture[ResponseT], reply: zenoh.Reply | None) -> None:
        try:
            response.set_result(self._read(reply))
        except (ServiceError, CodecError) as error:
            response.set_exception(error)
        if self.on_response is not None:
            self.on_response(1)

    def post(self, response: ResponseFuture[ResponseT]) -> None:
        """Let the executor run the callbacks of a call's future."""
        # A response without callbacks is added only if the queue is empty: one response is enough
        # to end `spin_once`. If all were added, the queue would grow for ever in a program that
        # stops to spin as soon as its own call is over.
        if response.has_callbacks or not self._completed:
            self._completed.append(response)
        self._post()

    def __bool__(self) -> bool:
        """Return whether there is a completed call whose callbacks have not run."""
        return bool(self._completed)

    def take(self) -> ResponseFuture[ResponseT] | None:
        """Return the oldest completed call whose callbacks have not run, or `None`."""
        try:
            return self._completed.popleft()
        except IndexError:
            return None
