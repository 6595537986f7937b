"""Services of an action: they may answer much later, and go on after they have answered."""

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
    """A response, and what to do once it has been sent: a function or coroutine function."""

    message: Any
    then: Callable[[], Any]


class ActionService(Service[Any, Any]):
    """A service whose callback may also return a `Reply`, or a `Future` of its response.

    It takes no turn of its callback group while the future is pending. Requests that still wait for
    one when the service is destroyed fail for their callers, as if the process had ended.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        self._waiting: dict[int, zenoh.Query] = {}
        self._then: deque[Callable[[], Any]] = deque()
        super().__init__(*args, **kwargs)

    def _answer(self, who: bytes, query: zenoh.Query, response: Any) -> None:
        if isinstance(response, Future):
            self._waiting[id(query)] = query
            response.add_waker(lambda: self._answer_when_over(who, query, response))
            if self._is_destroyed:
                self._drop_waiting()  # another thread destroyed it meanwhile
        elif isinstance(response, Reply):
            super()._answer(who, query, response.message)
            self._then.append(response.then)
        else:
            super()._answer(who, query, response)

    def execute(self, taken: tuple[zenoh.Query, float]) -> Coroutine[Any, Any, None] | None:
        """Answer a request, and go on in the same turn: a mistake there is not the caller's."""
        outcome = super().execute(taken)
        return self._go_on() if outcome is None else outcome

    async def _answer_later(
        self, who: bytes, query: zenoh.Query, outcome: Coroutine[Any, Any, Any]
    ) -> None:
        await super()._answer_later(who, query, outcome)
        more = self._go_on()
        if more is not None:
            await more

    def _go_on(self) -> Coroutine[Any, Any, None] | None:
        if not self._then:
            return None
        outcome = self._then.popleft()()
        return outcome if inspect.iscoroutine(outcome) else None

    def _answer_when_over(self, who: bytes, query: zenoh.Query, response: Future[Any]) -> None:
        if self._waiting.pop(id(query), None) is not None:
            super()._answer(who, query, response.result())

    def destroy(self) -> None:
        """Serve no more, and let all requests that wait fail; may be called twice."""
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
    """Return a new service of a node; its coroutine function answers at once where it can."""
    handle = node.handle
    service = ActionService(
        handle.context,
        srv_type,
        lambda request, response: start(callback(request, response)),
        handle.endpoint(EntityKind.SERVICE, node.resolve_service_name(name), srv_type, qos_profile),
        ready_queue=handle.ready_queue,
        callback_group=callback_group,
        logger_name=handle.logger_name,
    )
    handle.services.append(service)
    callback_group.add_entity(service)
    handle.ready_queue.add(service)
    return service


def start(coroutine: Coroutine[Any, Any, Any]) -> Any:
    """Run a coroutine to its end and return its result; if it has to wait, return its rest.

    A callback that need not wait is answered inside the call, also where no executor could go on
    with a coroutine.
    """
    try:
        awaited = coroutine.send(None)
    except StopIteration as stop:
        return stop.value
    return _go_on(coroutine, awaited)


async def _go_on(coroutine: Coroutine[Any, Any, Any], awaited: Any) -> Any:
    return await _steps(coroutine, awaited)


@types.coroutine
def _steps(coroutine: Coroutine[Any, Any, Any], awaited: Any) -> Generator[Any, None, Any]:
    while True:
        yield awaited
        try:
            awaited = coroutine.send(None)
        except StopIteration as stop:
            return stop.value


async def call(function: Callable[..., Any], *args: Any) -> Any:
    """Call a function or coroutine function and return its result."""
    outcome = function(*args)
    return await outcome if inspect.isawaitable(outcome) else outcome
