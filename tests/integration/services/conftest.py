"""Server and caller in two contexts, with a service that adds two numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot

from example_interfaces.srv import AddTwoInts

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin

Request, Response = AddTwoInts.Request, AddTwoInts.Response


def add(request: Any, response: Any) -> Any:
    response.sum = request.a + request.b
    return response


@pytest.fixture
def server(make_context: MakeContext, spin: Spin) -> zbot.Node:
    """Return a node in a session and thread of its own, without services."""
    node = zbot.Node("server", context=make_context())
    spin(node)
    return node


@pytest.fixture
def caller(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("caller", context=make_context())


def client_of(node: zbot.Node, name: str = "add") -> Any:
    client = node.create_client(AddTwoInts, name)
    assert client.wait_for_service(5)
    return client
