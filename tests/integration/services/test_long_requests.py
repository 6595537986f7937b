"""Tests of service calls that take longer than a query of Zenoh may take."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.services.conftest import Request, add, client_of
from zbot.node.errors import ServiceError
from zbot.node.service_request import ServiceRequest

from example_interfaces.srv import AddTwoInts

if TYPE_CHECKING:
    import zenoh

    from tests.conftest import MakeContext


"""A request that outlasts the limit of Zenoh's queries is sent again and served once."""


@pytest.fixture(autouse=True)
def short_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("zbot.node.service_request._FIRST_TIMEOUT_S", 0.1)
    monkeypatch.setattr("zbot.node.service_request._LATE_S", 0.02)


def answer(client: zbot.Client[Any, Any], kind: str) -> int:
    """Return the sum of 1 and 2 by a call of a kind."""
    if kind == "call":
        return int(client.call(Request(a=1, b=2), timeout_sec=10).sum)
    future = client.call_async(Request(a=1, b=2))
    assert wait_until(future.done, 10)
    return int(future.result().sum)


@pytest.mark.parametrize("kind", ["call", "call_async"])
@pytest.mark.parametrize("is_coroutine", [False, True])
def test_a_slow_handler_is_called_once(
    kind: str, is_coroutine: bool, server: zbot.Node, caller: zbot.Node
) -> None:
    served: list[int] = []
    gate: zbot.Future[None] = zbot.Future()
    opened = threading.Event()

    def open_gate() -> None:
        gate.set_result(None)
        opened.set()

    threading.Timer(0.5, open_gate).start()

    def slow(request: Any, response: Any) -> Any:
        served.append(request.a)
        assert opened.wait(5)
        return add(request, response)

    async def slow_coroutine(request: Any, response: Any) -> Any:
        served.append(request.a)
        await gate
        return add(request, response)

    server.create_service(AddTwoInts, "add", slow_coroutine if is_coroutine else slow)
    client = client_of(caller)
    assert answer(client, kind) == 3
    assert served == [1]


def test_a_late_error_is_received(make_context: MakeContext, caller: zbot.Node) -> None:
    opened = threading.Event()
    threading.Timer(0.3, opened.set).start()

    async def refuse(_request: Any, _response: Any) -> Any:
        assert opened.wait(5)
        raise ValueError("too late")

    server = zbot.Node("server", context=make_context())
    server.create_service(AddTwoInts, "add", refuse)
    executor = zbot.MultiThreadedExecutor(2, context=server.context)
    executor.add_node(server)

    def serve() -> None:
        while server.context.ok():
            try:
                executor.spin()
            except ValueError:
                continue
            except zbot.ExternalShutdownException:
                return

    thread = threading.Thread(target=serve)
    thread.start()
    try:
        with pytest.raises(ServiceError, match="too late"):
            client_of(caller).call(Request(), timeout_sec=10)
    finally:
        executor.shutdown()
        server.context.shutdown()
        thread.join(5)


@pytest.mark.parametrize("kind", ["call", "call_async"])
def test_a_request_whose_reply_the_network_held_up_is_served_once(
    kind: str, server: zbot.Node, caller: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.node.service_request._LATE_S", 100.0)  # the server was quick
    held_up: list[zenoh.Reply] = []

    def is_timeout(request: ServiceRequest, reply: zenoh.Reply) -> bool:
        if held_up:
            return False
        held_up.append(reply)  # stands for a reply that comes after the timeout
        request._has_timed_out = True
        return True

    monkeypatch.setattr(ServiceRequest, "is_timeout", is_timeout)
    served: list[int] = []

    def count(request: Any, response: Any) -> Any:
        served.append(request.a)
        return add(request, response)

    server.create_service(AddTwoInts, "add", count)
    client = client_of(caller)
    assert answer(client, kind) == 3
    assert len(held_up) == 1
    assert served == [1]
    assert client.call(Request(a=4, b=2), timeout_sec=10).sum == 6
    assert served == [1, 4]
