"""Tests of the WebSocket where clients of rosbridge connect."""

from __future__ import annotations

import asyncio
import json
import threading
import weakref
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

import pytest

from zbot.observer.serving.client_budget import Clients
from zbot.remote.types import UnknownTypeError
from zbot.web.rosbridge import endpoint
from zbot.web.rosbridge.client_message import RosbridgeError

if TYPE_CHECKING:
    from collections.abc import Callable


class Socket:
    """Client without a network."""

    client = None

    def __init__(self) -> None:
        self.events = asyncio.Queue[dict[str, str]]()
        self.sent = asyncio.Queue[str]()

    async def accept(self) -> None: ...

    async def close(self, _code: int, _reason: str) -> None: ...

    async def receive(self) -> dict[str, str]:
        return await self.events.get()

    async def send_text(self, text: str) -> None:
        self.sent.put_nowait(text)

    def send(self, **fields: str) -> None:
        self.events.put_nowait({"type": "websocket.receive", "text": json.dumps(fields)})

    async def error(self) -> str:
        return str(json.loads(await asyncio.wait_for(self.sent.get(), 5.0))["msg"])

    def leave(self) -> None:
        self.events.put_nowait({"type": "websocket.disconnect"})


class FakeBridge:
    """Bridge with one thread of each kind. No node knows a type, and they say so after `answer`."""

    def __init__(self) -> None:
        self.answer = threading.Event()
        self.clients = Clients()
        self.threads, self.waiting_threads = ThreadPoolExecutor(1), ThreadPoolExecutor(1)
        self.node = SimpleNamespace(
            resolve_topic_name=str,
            resolve_service_name=str,
            context=SimpleNamespace(ok=lambda: True),
        )
        self.is_read_only, self.sentence = False, str

    def graph(self) -> Any:
        return SimpleNamespace(services=lambda: [("/lamp", ["robot_msgs/srv/Lamp"])])

    def interface(self, _kind: str, name: str) -> Any:
        assert self.answer.wait(10.0)
        raise UnknownTypeError(name)

    def end_client(self, close: Callable[[], None]) -> None:
        close()


def test_news_after_the_end_of_the_server_are_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[Callable[..., Any]] = []

    def session(_bridge: Any, *functions: Callable[..., Any]) -> None:
        given.extend(functions)
        raise RosbridgeError("enough")

    monkeypatch.setattr(endpoint, "Session", session)
    bridge: Any = SimpleNamespace(clients=Clients())
    socket: Any = Socket()
    loop = asyncio.new_event_loop()
    with pytest.raises(RosbridgeError, match="enough"):
        loop.run_until_complete(endpoint.endpoint(bridge)(socket))
    loop.close()
    wake, call_later = given
    wake()
    call_later(1.0, wake)()


def test_a_stopped_timeout_keeps_nothing_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[Callable[..., Any]] = []

    def session(_bridge: Any, *functions: Callable[..., Any]) -> None:
        given.extend(functions)
        raise RosbridgeError("enough")

    class Call:
        def fail(self) -> None:
            raise AssertionError

    async def run() -> None:
        with pytest.raises(RosbridgeError, match="enough"):
            await endpoint.endpoint(cast("Any", SimpleNamespace(clients=Clients())))(
                cast("Any", Socket())
            )
        call = Call()
        held = weakref.ref(call)
        stop = given[1](3600.0, call.fail)
        del call
        await asyncio.sleep(0)
        assert held() is not None
        stop()
        await asyncio.sleep(0)
        assert held() is None

    monkeypatch.setattr(endpoint, "Session", session)
    asyncio.run(run())


@pytest.mark.parametrize(
    "message",
    [
        {"op": "subscribe", "topic": "/a", "type": "robot_msgs/msg/Lamp"},
        {"op": "advertise", "topic": "/a", "type": "robot_msgs/msg/Lamp"},
        {"op": "advertise_service", "service": "/a", "type": "robot_msgs/srv/Lamp"},
        {"op": "call_service", "service": "/lamp"},
        {"op": "advertise_action", "action": "/a", "type": "robot_msgs/action/Lamp"},
        {"op": "send_action_goal", "action": "/a", "action_type": "robot_msgs/action/Lamp"},
    ],
    ids=lambda message: message["op"],
)
def test_only_the_client_that_needs_an_unknown_type_waits_for_nodes(
    message: dict[str, str],
) -> None:
    async def run() -> None:
        bridge: Any = FakeBridge()
        sockets: Any = Socket(), Socket()
        tasks = [asyncio.ensure_future(endpoint.endpoint(bridge)(socket)) for socket in sockets]
        slow, quick = sockets
        slow.send(**message)
        quick.send(op="dance")
        assert "there is no operation 'dance'" in await quick.error()
        assert slow.sent.empty()
        bridge.answer.set()
        answer = json.loads(await asyncio.wait_for(slow.sent.get(), 5.0))
        assert "no definition of robot_msgs/" in answer.get("msg", answer.get("values"))
        for socket in sockets:
            socket.leave()
        await asyncio.gather(*tasks)
        assert slow.sent.empty()

    asyncio.run(run())
