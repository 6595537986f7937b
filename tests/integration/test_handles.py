"""What a node's parts give for `handle`, and what is left of them when they are destroyed."""

from __future__ import annotations

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

    MakeContext = Callable[[], zbot.Context]

PARTS: dict[str, Callable[[zbot.Node], Any]] = {
    "publisher": lambda node: node.create_publisher(String, "chatter", 1),
    "subscription": lambda node: node.create_subscription(String, "chatter", print, 1),
    "service": lambda node: node.create_service(Trigger, "go", lambda _, response: response),
    "client": lambda node: node.create_client(Trigger, "go"),
    "timer": lambda node: node.create_timer(1.0, print),
}


@pytest.fixture
def node(make_context: MakeContext) -> zbot.Node:
    return zbot.Node("owner", context=make_context())


@pytest.mark.parametrize("kind", PARTS)
def test_a_handle_can_be_held_until_its_part_is_destroyed(node: zbot.Node, kind: str) -> None:
    part = PARTS[kind](node)
    with part.handle, part.handle:
        pass
    assert getattr(node, f"destroy_{kind}")(part)
    with pytest.raises(InvalidHandleError), part.handle:
        pass


def test_a_node_lists_its_own_parts_alone(node: zbot.Node) -> None:
    make = PARTS["publisher"]
    make(node)
    assert [one.topic_name for one in node.publishers] == ["/parameter_events", "/chatter"]


def test_a_destroyed_node_has_no_parts(node: zbot.Node) -> None:
    for make in PARTS.values():
        make(node)
    node.destroy_node()
    for kind in PARTS:
        assert list(getattr(node, f"{kind}s")) == []


def test_log_lines_do_not_pass_a_replaced_publish(
    node: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    heard: list[str] = []
    monkeypatch.setattr(Publisher, "publish", lambda _, msg: heard.append(msg.data))
    node.get_logger().warning("this goes to /rosout all the same")
    PARTS["publisher"](node).publish(String(data="mine"))
    assert heard == ["mine"]


def test_a_request_can_be_taken_and_answered_without_an_executor(node: zbot.Node) -> None:
    service, client = PARTS["service"](node), PARTS["client"](node)
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


def test_a_client_tells_of_responses_until_it_is_told_not_to(node: zbot.Node) -> None:
    client = PARTS["client"](node)
    PARTS["service"](node)
    assert client.wait_for_service(5)
    told: list[int] = []
    client.handle.set_on_new_response_callback(told.append)

    def call() -> None:
        future = client.call_async(Trigger.Request())
        zbot.spin_until_future_complete(node, future, timeout_sec=5)
        assert future.done()

    call()
    assert wait_until(lambda: told == [1])
    client.handle.clear_on_new_response_callback()
    call()
    assert told == [1]
