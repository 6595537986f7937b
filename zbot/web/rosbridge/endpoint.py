"""WebSocket endpoint of the server, to which clients of rosbridge connect."""

from __future__ import annotations

import asyncio
import contextlib
import time
from typing import TYPE_CHECKING, TypeVar

from starlette.websockets import WebSocketDisconnect

from zbot.observer.serving.address import other_machine
from zbot.observer.serving.client_budget import ClientBudget, OverBudgetError
from zbot.web.rosbridge.dispatcher import Dispatcher
from zbot.web.rosbridge.session import Session

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from starlette.websockets import WebSocket

    from zbot.web.rosbridge.bridge import Bridge

T = TypeVar("T")

_TRY_AGAIN_LATER = 1013
_POLICY_VIOLATION = 1008


def endpoint(bridge: Bridge) -> Callable[[WebSocket], Awaitable[None]]:
    """Return the function that serves one client until the client disconnects."""

    async def serve(socket: WebSocket) -> None:
        await socket.accept()
        loop = asyncio.get_running_loop()
        has_news = asyncio.Event()

        def run(function: Callable[..., object], *arguments: object) -> None:
            with contextlib.suppress(RuntimeError):  # the server is ending and has closed its loop
                loop.call_soon_threadsafe(function, *arguments)

        def wake() -> None:
            run(has_news.set)

        def call_later(delay_s: float, function: Callable[[], None]) -> Callable[[], None]:
            # Filled and read only in the loop, in this order.
            timers: list[asyncio.TimerHandle] = []
            run(lambda: timers.append(loop.call_later(delay_s, function)))
            return lambda: run(lambda: timers.pop().cancel())

        machine = other_machine("" if socket.client is None else socket.client.host)
        try:
            bridge.clients.add(machine)
        except OverBudgetError as error:
            await socket.close(_TRY_AGAIN_LATER, str(error))
            return
        session = Session(bridge, wake, call_later)
        dispatcher = Dispatcher(session)
        receiving = asyncio.create_task(_receive(socket, session, dispatcher))
        sending = asyncio.create_task(_send(socket, session, has_news))
        try:
            await asyncio.wait({receiving, sending}, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in (receiving, sending):
                task.cancel()
            outcomes = await asyncio.gather(receiving, sending, return_exceptions=True)
            bridge.clients.remove(machine)
            bridge.end_client(dispatcher.close)
            for outcome in outcomes:
                if isinstance(outcome, Exception):
                    bridge.report(outcome)

    return serve


async def _receive(socket: WebSocket, session: Session, dispatcher: Dispatcher) -> None:
    budget = ClientBudget()
    while True:
        event = await socket.receive()
        if event["type"] == "websocket.disconnect":
            return
        data = event.get("text")
        if data is None:
            data = event.get("bytes") or b""
        try:
            budget.check_message(len(data))
        except OverBudgetError as error:
            if str(error):
                session.report("error", str(error))
            await asyncio.sleep(budget.refusal_pause_s(len(data)))
            continue
        # The next message is received only after that, so a client that sends too fast has to wait.
        used_s = await _execute(session.bridge, dispatcher, data)
        delay_s = budget.note_work(used_s)
        if delay_s:
            await asyncio.sleep(delay_s)


async def _execute(bridge: Bridge, dispatcher: Dispatcher, data: str | bytes) -> float:
    """Execute a message in a thread. Return the time of the processor that it needed, in seconds.

    If the message needs a definition from another machine, a thread that may wait continues.
    """
    loop = asyncio.get_running_loop()
    is_done, used_s = await loop.run_in_executor(bridge.threads, _timed, dispatcher.take, data)
    if not is_done:
        _, more_s = await loop.run_in_executor(bridge.waiting_threads, _timed, dispatcher.finish)
        used_s += more_s
    return used_s


def _timed(function: Callable[..., T], *arguments: object) -> tuple[T, float]:
    """Call a function, and return its result and the time of the processor that it needed."""
    began_s = time.thread_time()
    result = function(*arguments)
    return result, time.thread_time() - began_s


async def _send(socket: WebSocket, session: Session, has_news: asyncio.Event) -> None:
    loop = asyncio.get_running_loop()
    delay_s: float | None = None
    try:
        while not session.outbox.is_overrun:
            if delay_s != 0:
                await _wait(has_news, delay_s)
            has_news.clear()
            batch = await loop.run_in_executor(session.bridge.threads, session.outbox.take)
            for frame in batch.frames:
                # Sending waits while the client reads too slowly.
                if isinstance(frame, str):
                    await socket.send_text(frame)
                else:
                    await socket.send_bytes(frame)
            delay_s = batch.delay_s
        await socket.close(_POLICY_VIOLATION, "too many responses wait, as you read too slowly")
    except WebSocketDisconnect:
        return  # the client has disconnected meanwhile


async def _wait(event: asyncio.Event, timeout_s: float | None) -> None:
    try:
        await asyncio.wait_for(event.wait(), timeout_s)
    except asyncio.TimeoutError:
        return
