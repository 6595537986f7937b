"""Limits of a client of rosbridge, and its end."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tests.conftest import wait_until
from tests.integration.rosbridge.web_program import WebProgram, repeat_until_sent
from zbot.observer.system import System
from zbot.web.rosbridge import service_operations, topic_operations
from zbot.web.rosbridge.bridge import Bridge

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

    import zbot
    from tests.conftest import Spinner


def test_a_read_only_server_only_reads(
    domain: int, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    node.create_service(AddTwoInts, "add", lambda _request, response: response)
    node.declare_parameter("limit", 2.0)
    spin(node)
    with System(domain_id=domain, read_only=True) as system:
        web = WebProgram(Bridge(system))
        graph = web.session.bridge.graph
        assert wait_until(lambda: "/add" in dict(graph().services()), 10)
        action = "example_interfaces/Fibonacci"
        for op, fields in (
            ("advertise", {"topic": "/a", "type": "std_msgs/String"}),
            ("publish", {"topic": "/a", "msg": {}}),
            ("advertise_service", {"service": "/a", "type": "std_srvs/Empty"}),
            ("advertise_action", {"action": "/a", "type": action}),
        ):
            web.send(op, **fields)
            assert "--read-only" in web.wait_for("status")["msg"]
        web.send("call_service", service="/add", id=1)
        assert "--read-only" in web.wait_for("service_response", id=1)["values"]
        web.send("send_action_goal", action="/a", action_type=action, id=2)
        assert "--read-only" in web.wait_for("action_result", id=2)["values"]
        args = {"name": "/robot:limit", "value": "3"}
        web.send("call_service", service="/rosapi/set_param", args=args, id=3)
        assert "--read-only" in web.wait_for("service_response", id=3)["values"]
        assert web.call("/rosapi/get_param", name="/robot:limit")["value"] == "2.0"
        web.session.bridge.close()


def test_what_a_client_has_created_ends_with_it(web: WebProgram, node: zbot.Node) -> None:
    web.send("advertise", topic="/a", type="std_msgs/String")
    web.send("subscribe", topic="/b", type="std_msgs/String")
    web.send("advertise_service", service="/c", type="std_srvs/Empty")
    web.send("advertise_action", action="/d", type="example_interfaces/Fibonacci")
    assert wait_until(lambda: node.count_services("/d/_action/send_goal") == 1, 10)
    assert node.count_publishers("/a") == node.count_subscribers("/b") == 1
    assert node.count_services("/c") == 1
    web.dispatcher.close()
    assert wait_until(lambda: node.count_services("/d/_action/send_goal") == 0, 10)
    assert wait_until(lambda: node.count_publishers("/a") == node.count_subscribers("/b") == 0, 10)
    assert wait_until(lambda: node.count_services("/c") == 0, 10)
    web.send("advertise", topic="/late", type="std_msgs/String")
    assert node.count_publishers("/late") == 0
    assert len(web.session.bridge.shared) == 0


def test_a_client_has_limits(web: WebProgram, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(topic_operations, "MAX_PUBLISHED", 1)
    monkeypatch.setattr(topic_operations, "MAX_SUBSCRIBED", 1)
    monkeypatch.setattr(service_operations, "MAX_SERVICES", 1)
    for op, name, kind in (
        ("advertise", "topic", "std_msgs/String"),
        ("subscribe", "topic", "std_msgs/String"),
        ("advertise_service", "service", "std_srvs/Empty"),
    ):
        web.send(op, **{name: "/one", "type": kind})
        assert web.read() == []
        web.send(op, **{name: "/two", "type": kind})
        assert "a client can" in web.wait_for("status")["msg"]


def test_a_slow_client_gets_a_warning_and_the_newest(web: WebProgram, node: zbot.Node) -> None:
    publisher = node.create_publisher(String, "fast", 100)
    web.send("set_level", level="warning")
    web.send("subscribe", topic="/fast", type="std_msgs/String", queue_length=2)
    assert repeat_until_sent(publisher, String(data="first"), web, "publish")
    for number in range(50):
        publisher.publish(String(data=str(number)))
    queue = next(iter(web.session.outbox._topics))
    assert wait_until(lambda: bool(queue.payloads) and b"49" in queue.payloads[-1], 10)
    assert len(queue.payloads) == 2
    assert "were dropped" in web.wait_for("status", level="warning")["msg"]
    assert web.wait_for("publish", msg={"data": "49"})
