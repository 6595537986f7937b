"""Tests of services between processes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.services.conftest import Request, add, client_of
from zbot.node.errors import ServiceError

from example_interfaces.srv import AddTwoInts

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin, Start

SERVER = """
import os, sys, time, zbot
from example_interfaces.srv import AddTwoInts
zbot.init()
node = zbot.Node("server")
def add(request, response):
    if request.a == -1:
        os._exit(9)
    if request.a == -2:
        print("working", flush=True)
        time.sleep(60)
    response.sum = request.a + request.b
    return response
node.create_service(AddTwoInts, "add", add)
print("ready", flush=True)
zbot.spin(node)
"""
SHORT_CLIENT = """
import zbot
from example_interfaces.srv import AddTwoInts
with zbot.init():
    node = zbot.Node("short")
    client = node.create_client(AddTwoInts, "add")
    client.wait_for_service(5)
    client.call_async(AddTwoInts.Request(a=40, b=2))
"""


def test_a_server_that_is_killed_fails_the_call_at_once(caller: zbot.Node, start: Start) -> None:
    process = start(source=SERVER)
    process.wait_for("ready")
    client = client_of(caller)
    future = client.call_async(Request(a=-2))
    process.wait_for("working")
    process.process.kill()
    assert wait_until(future.done, 1)
    assert isinstance(future.exception(), ServiceError)


def test_a_call_finds_the_replacing_server(caller: zbot.Node, start: Start) -> None:
    client = caller.create_client(AddTwoInts, "add")
    for turn in range(3):
        start(source=SERVER).wait_for("ready")
        assert client.wait_for_service(5)
        assert client.call(Request(a=turn)).sum == turn
        with pytest.raises(ServiceError, match="ended before it answered"):
            client.call(Request(a=-1))


def test_a_client_that_ends_after_sending_is_served(
    make_context: MakeContext, spin: Spin, start: Start
) -> None:
    served: list[int] = []

    def note(request: Any, response: Any) -> Any:
        served.append(request.a)
        return add(request, response)

    server = zbot.Node("server", context=make_context())
    server.create_service(AddTwoInts, "add", note)
    spin(server)
    for turn in range(1, 6):
        assert start(source=SHORT_CLIENT).wait() == 0
        assert wait_until(lambda turn=turn: len(served) == turn)  # type: ignore[misc]
