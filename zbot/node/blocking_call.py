"""Functions that make a thread wait for the reply to a service request.

The thread that waits may belong to an executor that also has a server of this service. So during
the wait, the thread runs the callback of this server. Otherwise the call would never end.
"""

from __future__ import annotations

import contextlib
from functools import partial
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, Protocol, cast

from zbot.executor.callback_stack import current_executor
from zbot.process import signals
from zbot.threads.deadline import Deadline
from zbot.threads.wakeup import LONGEST_WAIT_S, BusyWait, waking

if TYPE_CHECKING:
    from collections.abc import Callable

    import zenoh

    from zbot.context import Context
    from zbot.executor.spinnable import NodeExecutor
    from zbot.node.service import Service
    from zbot.node.service_request import ServiceRequest

# This object in the queue means: a server has a request, or the context was shut down.
_WOKEN = object()


class Caller(Protocol):
    """The part of a client that a blocking call uses."""

    busy_wait: BusyWait  #: for the threads that wait

    @property
    def context(self) -> Context:
        """The context of the client."""
        ...

    @property
    def service_name(self) -> str:
        """The full name of the service."""
        ...

    def send(
        self,
        request: ServiceRequest,
        on_reply: Callable[[zenoh.Reply], object],
        on_end: Callable[[], object],
    ) -> None:
        """Send a request. Zenoh's thread calls `on_reply` for each reply, then `on_end` once."""
        ...


def wait_for_reply(
    client: Caller, request: ServiceRequest, timeout_sec: float | None
) -> zenoh.Reply | None:
    """Send a request and return its reply, or `None` if the server ended without a reply.

    Raises:
        TimeoutError: No reply came within `timeout_sec`.
        NotInitializedError: The context was shut down during the wait.
    """
    # Zenoh's thread puts each reply into this queue. When an attempt ends, Zenoh's thread puts the
    # number of the attempt into the queue. `put` is written in C. A Python function would cost
    # 20 us each time, because Zenoh's thread would need a new frame.
    arrivals: SimpleQueue[Any] = SimpleQueue()
    executor = current_executor()
    own = [] if executor is None else _servers_of(executor, client.service_name)
    serve = partial(_serve, executor, own)
    deadline = Deadline(timeout_sec)
    with waking(partial(arrivals.put, _WOKEN), client.context, *own):
        attempt = 0
        while True:
            client.send(request, arrivals.put, partial(arrivals.put, attempt))
            while (reply := _wait(client, arrivals, attempt, deadline, serve)) is not None:
                if not request.is_timeout(reply):
                    return reply
            if not request.is_to_be_repeated():
                return None
            attempt += 1


def _wait(
    client: Caller,
    arrivals: SimpleQueue[Any],
    attempt: int,
    deadline: Deadline,
    serve: Callable[[], bool],
) -> zenoh.Reply | None:
    while True:
        while serve():
            pass
        left_s = deadline.left_s
        client.busy_wait.begin(arrivals.qsize)
        try:
            arrived = arrivals.get(timeout=min(left_s, LONGEST_WAIT_S))
        except Empty:
            if not left_s:
                sentence = f"{client.service_name}: there was no response in time"
                raise TimeoutError(sentence) from None
            continue
        client.busy_wait.end(came=True)
        if arrived == attempt:
            return None
        if arrived is _WOKEN:
            if client.context.is_over:
                signals.raise_not_initialized("a service call")
        elif not isinstance(arrived, int):
            return cast("zenoh.Reply", arrived)


def _servers_of(executor: NodeExecutor, service_name: str) -> list[Service[Any, Any]]:
    return [
        service
        for node in executor.get_nodes()
        for service in node.handle.services
        if service.service_name == service_name
    ]


def _serve(executor: NodeExecutor | None, own: list[Service[Any, Any]]) -> bool:
    """Run the next request of servers in the thread's executor. Return whether there was one."""
    if executor is None:
        return False
    # An exception of a server's callback is ignored here. The client gets an error reply.
    with contextlib.suppress(Exception):
        return any(executor.serve(service) for service in own)
    return True
