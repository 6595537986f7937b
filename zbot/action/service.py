"""Services of an action. They may respond later, and may do work after the response."""

from __future__ import annotations

import inspect
import types
from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot.executor.task import Future
from zbot.node.service import Service
from zbot.wire.tokens import EntityKind

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Generator

    import zenoh

    from zbot.executor.callback_group import CallbackGroup
    from zbot.node.node import Node
    from zbot.qos import QoSProfile


@dataclass(frozen=True)
class Reply:
    """A response, and a function or coroutine function to call after the response was sent."""

    message: Any
    then: Callable[[], Any]


class ActionService(Service[Any, Any]):
    """A service whose callback may also return a `Reply`, or a `Future` of its response.

    While the future is pending, the service does not hold its callback group. If the service is
    destroyed, waiting requests fail for their callers, as if the process had ended.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        self._waiting: dict[int, zenoh.Query] = {}
        self._after_reply: deque[Callable[[], Any]] = deque()
        super().__init__(*args, **kwargs)

    def _answer(self, request_id: bytes, query: zenoh.Query, response: Any) -> None:
        if isinstance(response, Future):
            self._waiting[id(query)] = query
            response.add_waker(lambda: self._answer_when_over(request_id, query, response))
            if self._is_destroyed:
                self._drop_waiting()  # another thread has destroyed the service
        elif isinstance(response, Reply):
            super()._answer(request_id, query, response.message)
            self._after_reply.append(response.then)
        else:
            super()._answer(request_id, query, response)

    def execute(self, taken: tuple[zenoh.Query, float]) -> Coroutine[Any, Any, None] | None:
        """Respond, then call the reply's function. The client gets no errors of this function."""
        outcome = super().execute(taken)
        return self._run_after_reply() if outcome is None else outcome

    async def _answer_later(
        self, request_id: bytes, query: zenoh.Query, outcome: Coroutine[Any, Any, Any]
    ) -> None:
        await super()._answer_later(request_id, query, outcome)
        rest = self._run_after_reply()
        if rest is not None:
            await rest

    def _run_after_reply(self) -> Coroutine[Any, Any, None] | None:
        if not self._after_reply:
            return None
        outcome = self._after_reply.popleft()()
        return outcome if inspect.iscoroutine(outcome) else None

    def _answer_when_over(
        self, request_id: bytes, query: zenoh.Query, response: Future[Any]
    ) -> None:
        if self._waiting.pop(id(query), None) is not None:
            super()._answer(request_id, query, response.result())

    def destroy(self) -> None:
        """Destroy the service, and let all waiting requests fail. A second call does nothing."""
        super().destroy()
        self._drop_waiting()

    def _drop_waiting(self) -> None:
        for key in list(self._waiting):
            query = self._waiting.pop(key, None)
            if query is not None:
                query.drop()


def create_action_service(
    node: Node,
    srv_type: type[Any],
    name: str,
    callback: Callable[[Any, Any], Coroutine[Any, Any, Any]],
    *,
    qos_profile: QoSProfile,
    callback_group: CallbackGroup,
) -> ActionService:
    """Return a new service of a node. The service responds immediately, unless `callback` waits."""
    handle = node.handle
    name = node.resolve_service_name(name)
    with handle.context.until_shutdown(f"the node {handle.full_name}"):
        service = ActionService(
            handle.context,
            srv_type,
            lambda request, response: run_until_await(callback(request, response)),
            handle.endpoint(EntityKind.SERVICE, name, srv_type, qos_profile),
            ready_queue=handle.ready_queue,
            callback_group=callback_group,
            logger_name=handle.logger_name,
        )
    handle.services.append(service)
    handle.add(service)
    return service


def run_until_await(coroutine: Coroutine[Any, Any, Any]) -> Any:
    """Run a coroutine and return its result.

    If the coroutine has to wait, return a new coroutine that runs the rest. A coroutine that does
    not wait ends inside this function, and needs no executor.
    """
    try:
        awaited = coroutine.send(None)
    except StopIteration as stop:
        return stop.value
    return _continue(coroutine, awaited)


async def _continue(coroutine: Coroutine[Any, Any, Any], awaited: Any) -> Any:
    return await _steps(coroutine, awaited)


@types.coroutine
def _steps(coroutine: Coroutine[Any, Any, Any], awaited: Any) -> Generator[Any, None, Any]:
    while True:
        yield awaited
        try:
            awaited = coroutine.send(None)
        except StopIteration as stop:
            return stop.value
