"""Tests of the `handle` of nodes and of their entities, also after their destruction."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.errors import InvalidHandleError
from zbot.node.publisher import Publisher

from std_msgs.msg import String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext

ENTITIES: dict[str, Callable[[zbot.Node], Any]] = {
    "publisher": lambda node: node.create_publisher(String, "chatter", 1),
    "subscription": lambda node: node.create_subscription(String, "chatter", print, 1),
    "service": lambda node: node.create_service(Trigger, "go", lambda _, response: response),
    "client": lambda node: node.create_client(Trigger, "go"),
    "timer": lambda node: node.create_timer(1.0, print),
}


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("owner", context=make_context())


@pytest.mark.parametrize("kind", ENTITIES)
def test_a_handle_is_valid_until_its_entity_is_destroyed(node: zbot.Node, kind: str) -> None:
    part = ENTITIES[kind](node)
    with part.handle, part.handle:
        pass
    assert getattr(node, f"destroy_{kind}")(part)
    with pytest.raises(InvalidHandleError), part.handle:
        pass


def test_a_node_lists_only_its_own_entities(node: zbot.Node) -> None:
    make = ENTITIES["publisher"]
    make(node)
    assert [publisher.topic_name for publisher in node.publishers] == [
        "/parameter_events",
        "/chatter",
    ]


def test_the_class_has_no_entities() -> None:
    members = dict(inspect.getmembers(zbot.Node))
    assert {f"{kind}s" for kind in ENTITIES} <= set(members)


def test_a_destroyed_node_has_no_entities(node: zbot.Node) -> None:
    for make in ENTITIES.values():
        make(node)
    node.destroy_node()
    for kind in ENTITIES:
        assert list(getattr(node, f"{kind}s")) == []


def test_log_lines_use_the_real_publish(node: zbot.Node, monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[str] = []
    monkeypatch.setattr(Publisher, "publish", lambda _, msg: heard.append(msg.data))
    node.get_logger().warning("this goes to /rosout all the same")
    ENTITIES["publisher"](node).publish(String(data="mine"))
    assert heard == ["mine"]


def test_a_request_can_be_taken_and_answered_without_an_executor(node: zbot.Node) -> None:
    service, client = ENTITIES["service"](node), ENTITIES["client"](node)
    assert client.wait_for_service(5)
    assert service.handle.service_take_request(Trigger.Request) == (None, None)
    future = client.call_async(Trigger.Request())
    assert wait_until(lambda: service.has_work)
    request, header = service.handle.service_take_request(Trigger.Request)
    assert isinstance(request, Trigger.Request)
    assert 0 < header.source_timestamp <= header.received_timestamp
    service.handle.service_send_response(Trigger.Response(message="by hand"), header)
    assert wait_until(future.done)
    assert future.result().message == "by hand"


def test_a_response_callback_is_called_until_it_is_cleared(node: zbot.Node) -> None:
    client = ENTITIES["client"](node)
    ENTITIES["service"](node)
    assert client.wait_for_service(5)
    counts: list[int] = []
    client.handle.set_on_new_response_callback(counts.append)

    def call() -> None:
        future = client.call_async(Trigger.Request())
        zbot.spin_until_future_complete(node, future, timeout_sec=5)
        assert future.done()

    call()
    assert wait_until(lambda: counts == [1])
    client.handle.clear_on_new_response_callback()
    call()
    assert counts == [1]


def test_a_nodes_handle_is_valid_until_the_end_of_its_block(talker: zbot.Node) -> None:
    with talker.handle:
        talker.handle.destroy_when_not_in_use()
        with talker.handle:
            pass
    with pytest.raises(InvalidHandleError), talker.handle:
        pass
