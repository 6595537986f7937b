"""Router of ROS 2, nodes of zbot that speak ROS 2's dialect, and nodes of plain Zenoh."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.integration.rmw.ros2_node import Ros2Node
from zbot.transport.config import MEETING_PORT
from zbot.transport.rmw_choice import RMW_VARIABLE, RMW_ZENOH
from zbot.transport.rmw_meeting import RmwRouter

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    MakeNode = Callable[..., zbot.Node]
    MakePlain = Callable[..., Ros2Node]
    SetRouter = Callable[[str], None]


@pytest.fixture
def set_router(monkeypatch: pytest.MonkeyPatch) -> SetRouter:
    """Return a function that lets programs speak ROS 2's dialect and connect to a router."""

    def set_endpoint(endpoint: str) -> None:
        monkeypatch.setenv(RMW_VARIABLE, RMW_ZENOH)
        monkeypatch.setenv("ZENOH_CONFIG_OVERRIDE", f'connect/endpoints=["{endpoint}"]')

    return set_endpoint


@pytest.fixture
def endpoint(free_domain: int, set_router: SetRouter) -> str:
    """Return the endpoint of the test's router, which is not open yet."""
    found = f"tcp/127.0.0.1:{MEETING_PORT + free_domain}"
    set_router(found)
    return found


@pytest.fixture
def router(endpoint: str) -> Iterator[str]:
    with RmwRouter([endpoint], []).open():
        yield endpoint


@pytest.fixture
def domain(router: str, free_domain: int) -> int:  # noqa: ARG001 - the router must be open
    return free_domain


@pytest.fixture
def make_node(free_domain: int) -> Iterator[MakeNode]:
    """Return a function that makes nodes in contexts of their own."""
    made: list[zbot.Context] = []

    def make(name: str = "robot", rmw: str | None = None) -> zbot.Node:
        context = zbot.Context(rmw=rmw)
        context.init([], domain_id=free_domain)
        made.append(context)
        return zbot.Node(name, context=context)

    yield make
    for context in made:
        context.shutdown()


@pytest.fixture
def make_plain(endpoint: str, free_domain: int) -> Iterator[MakePlain]:
    """Return a function that makes plain nodes."""
    made: list[Ros2Node] = []

    def make(*, to: str = endpoint, name: str = "plain", **settings: object) -> Ros2Node:
        made.append(Ros2Node(to, free_domain, name, **settings))
        return made[-1]

    yield make
    for peer in made:
        peer.close()


@pytest.fixture
def plain(router: str, make_plain: MakePlain) -> Ros2Node:  # noqa: ARG001 - it must be open
    return make_plain()


@pytest.fixture
def node(router: str, make_node: MakeNode) -> zbot.Node:  # noqa: ARG001 - it must be open
    return make_node()


@pytest.fixture
def make_context(make_node: MakeNode) -> MakeNode:
    """Let the threads of `spin` end before the contexts of the nodes. No router is needed."""
    return make_node
