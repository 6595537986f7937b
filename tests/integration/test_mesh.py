"""Tests of nodes beyond the mesh of a domain, which are clients of the router."""

from __future__ import annotations

import os
import signal
import sys
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed, wait_until
from zbot.transport import router_process
from zbot.transport.mesh import PLACES, Mesh

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import Int64

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import MakeContext, Spin

pytestmark = [
    pytest.mark.own_dialect("ROS 2 has a router that the user starts, and no meeting port"),
    pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals"),
]


@pytest.fixture
def domain(free_domain: int) -> int:
    """Return a domain whose router is a process, as outside of tests."""
    return free_domain


@pytest.fixture
def first(make_context: MakeContext) -> zbot.Node:
    """Return a node in the mesh."""
    return zbot.Node("first", context=make_context())


@pytest.fixture
def full_mesh(first: zbot.Node, domain: int) -> Iterator[None]:  # noqa: ARG001 - `first` is in it
    meshes = [Mesh(domain) for _ in range(PLACES - 1)]
    assert all(mesh.enter() for mesh in meshes)
    yield
    for mesh in meshes:
        mesh.leave()


@pytest.fixture
def later(full_mesh: None, make_context: MakeContext) -> zbot.Node:  # noqa: ARG001 - before it
    """Return a node that is a client of the router."""
    return zbot.Node("later", context=make_context())


def peers(node: zbot.Node) -> int:
    return len(node.context.session.info.peers_zid())


def test_a_mesh_has_places_for_some_sessions(domain: int) -> None:
    meshes = [Mesh(domain) for _ in range(PLACES)]
    assert all(mesh.enter() for mesh in meshes)
    another = Mesh(domain)
    assert not another.enter()
    meshes[3].leave()
    assert another.enter()
    for mesh in [*meshes, another]:
        mesh.leave()


def test_a_session_gives_its_place_back(domain: int, make_context: MakeContext) -> None:
    contexts = [make_context() for _ in range(2)]
    nodes = [
        zbot.Node(f"node_{number}", context=context) for number, context in enumerate(contexts)
    ]
    assert wait_until(lambda: peers(nodes[0]) == 1)
    contexts[0].shutdown()
    meshes = [Mesh(domain) for _ in range(PLACES)]
    assert [mesh.enter() for mesh in meshes].count(True) == PLACES - 1
    for mesh in meshes:
        mesh.leave()


def test_a_later_node_has_no_link_to_other_nodes(first: zbot.Node, later: zbot.Node) -> None:
    assert peers(later) == peers(first) == 0
    assert len(later.context.session.info.routers_zid()) == 1


def test_a_later_node_sees_the_whole_graph(first: zbot.Node, later: zbot.Node) -> None:
    first.create_publisher(Int64, "count", 10)
    assert wait_until(lambda: later.get_node_names() == ["first", "later"])
    assert wait_until(lambda: later.count_publishers("count") == 1)
    later.create_subscription(Int64, "count", print, 10)
    assert wait_until(lambda: first.count_subscribers("count") == 1)


@pytest.mark.parametrize("backwards", [False, True], ids=["to a later node", "from a later node"])
def test_the_first_message_arrives(
    first: zbot.Node, later: zbot.Node, spin: Spin, backwards: bool
) -> None:
    sender, receiver = (later, first) if backwards else (first, later)
    received: list[int] = []
    receiver.create_subscription(Int64, "count", lambda msg: received.append(msg.data), 10)
    spin(receiver)
    publisher = sender.create_publisher(Int64, "count", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    for number in range(5):
        publisher.publish(Int64(data=number))
    assert wait_until(lambda: len(received) == 5)
    assert received == list(range(5))


def test_two_later_nodes_call_each_other(
    later: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    def add(request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        return response

    later.create_service(AddTwoInts, "add", add)
    spin(later)
    another = zbot.Node("another", context=make_context())
    client = another.create_client(AddTwoInts, "add")
    assert client.wait_for_service(5)
    spin(another)
    assert client.call(AddTwoInts.Request(a=2, b=3), timeout_sec=5).sum == 5


def test_a_later_node_links_to_the_next_router(
    first: zbot.Node, later: zbot.Node, spin: Spin, domain: int
) -> None:
    received: list[int] = []
    later.create_subscription(Int64, "count", lambda msg: received.append(msg.data), 10)
    spin(later)
    publisher = first.create_publisher(Int64, "count", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    router = router_process.pid(domain)
    assert router is not None
    os.kill(router, signal.SIGKILL)
    assert wait_until(lambda: router_process.pid(domain) not in {None, router})

    def arrives() -> bool:
        publisher.publish(Int64(data=7))
        return bool(received)

    assert wait_until(arrives)
    assert wait_until(lambda: later.get_node_names() == ["first", "later"])


def test_a_later_node_replaces_a_stopped_router(
    first: zbot.Node, later: zbot.Node, domain: int, spin: Spin
) -> None:
    """No new program needs the router, and the nodes hear each other again all the same."""
    inbox: list[int] = []
    later.create_subscription(Int64, "count", lambda message: inbox.append(message.data), 10)
    publisher = first.create_publisher(Int64, "count", 10)
    spin(later)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    peering = later.context._domain_session._peering
    assert wait_until(lambda: peering is not None and peering._watch_pause_s is not None)
    stopped = router_process.pid(domain)
    assert stopped is not None
    os.kill(stopped, signal.SIGSTOP)

    def is_heard() -> bool:
        publisher.publish(Int64(data=1))
        return bool(inbox)

    # After 10 s, Zenoh notices it. So this limit is the same on a busy machine.
    assert wait_until(lambda: router_process.pid(domain) not in {stopped, None}, 8 / allowed(1))
    assert wait_until(is_heard)
