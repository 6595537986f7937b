"""Node with parameters, and a client in another context."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from zbot.remote.parameter_client import AsyncParameterClient

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("robot", context=make_context(), namespace="lab")


@pytest.fixture
def client(node: zbot.Node, make_context: MakeContext, spin: Spin) -> AsyncParameterClient:
    """Return a client in another context, and spin both."""
    asking = zbot.Node("asking", context=make_context())
    client = AsyncParameterClient(asking, "/lab/robot")
    spin(node)
    spin(asking)
    assert client.wait_for_services(5)
    return client
