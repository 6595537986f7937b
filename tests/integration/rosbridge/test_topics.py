"""Topics of a web program, its wrong messages, and the form of what is sent."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.rosbridge.web_program import WebProgram, repeat_until_sent

from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Spinner

LATCHED = zbot.QoSProfile(depth=1, durability=zbot.DurabilityPolicy.TRANSIENT_LOCAL)


def test_subscribe_sends_messages_until_unsubscribe(web: WebProgram, node: zbot.Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    web.send("subscribe", topic="chatter", type="std_msgs/String", id="a")
    web.send("subscribe", topic="chatter", id="b")
    sent = repeat_until_sent(publisher, String(data="hello"), web, "publish")
    # The name is the client's own, as it finds its callback by it.
    assert sent == {"op": "publish", "topic": "chatter", "msg": {"data": "hello"}}
    web.send("unsubscribe", topic="chatter", id="a")
    assert repeat_until_sent(publisher, String(), web, "publish")
    web.send("unsubscribe", topic="chatter", id="b")
    assert wait_until(lambda: node.count_subscribers("chatter") == 0, 10)
    assert not [answer for answer in web.read() if answer["op"] == "status"]


def test_a_latched_message_and_nan_arrive(web: WebProgram, node: zbot.Node) -> None:
    node.create_publisher(LaserScan, "map", LATCHED).publish(LaserScan(ranges=[float("inf"), 1.0]))
    bridge = web.session.bridge
    assert wait_until(lambda: bool(bridge.graph().publishers("/map")), 10)
    web.send("subscribe", topic="/map")
    assert web.wait_for("publish")["msg"]["ranges"] == [None, 1.0]


def take_one(web: WebProgram) -> list[Any]:
    frames: list[Any] = []

    def has_come() -> bool:
        frames.extend(web.session.outbox.take().frames)
        return bool(frames)

    assert wait_until(has_come, 10)
    return frames


def test_compressions_and_fragments(web: WebProgram, node: zbot.Node) -> None:
    publisher = node.create_publisher(LaserScan, "scan", LATCHED)
    publisher.publish(LaserScan(ranges=[1.5] * 20))
    for compression, start in (("cbor", b"\xa3\x62op"), ("cbor-raw", b"\xa3\x62op")):
        web.send("subscribe", topic="/scan", type="sensor_msgs/LaserScan", compression=compression)
        [frame] = take_one(web)
        assert frame.startswith(start)
        assert (b"secs" in frame) == (compression == "cbor-raw")
        web.send("unsubscribe", topic="/scan")
    web.send("subscribe", topic="/scan", fragment_size=100)
    total = web.wait_for("fragment", num=0)["total"]
    assert total > 3
    assert web.wait_for("fragment", num=total - 1)
    web.send("subscribe", topic="/scan", compression="zip", id="z")
    assert "'zip' is not one of" in web.wait_for("status", id="z")["msg"]


def test_publish_reaches_nodes(
    web: WebProgram, node: zbot.Node, spin: Callable[..., Spinner]
) -> None:
    texts: list[str] = []
    poses: list[Any] = []
    node.create_subscription(String, "text", lambda message: texts.append(message.data), 10)
    node.create_subscription(PoseStamped, "pose", poses.append, 10)
    spin(node)
    web.send("advertise", topic="/text", type="std_msgs/String")
    assert wait_until(lambda: node.count_publishers("text") == 1, 10)
    web.send("publish", topic="/text", msg={"data": "a"})
    # Without an advertisement, the graph knows the type.
    assert wait_until(lambda: bool(web.session.bridge.graph().subscriptions("/pose")), 10)
    web.send("publish", topic="pose", msg={"pose": {"position": {"x": 2}}})
    assert wait_until(lambda: texts == ["a"] and len(poses) == 1, 10)
    assert poses[0].pose.position.x == 2.0
    assert poses[0].header.stamp != Time()
    web.send("unadvertise", topic="/text")
    assert wait_until(lambda: node.count_publishers("text") == 0, 10)
    assert web.read() == []


@pytest.mark.parametrize(
    ("op", "fields", "reason"),
    [
        ("dance", {}, "no operation 'dance'"),
        ("publish", {"topic": "/unknown", "msg": {}}, "advertise it first"),
        ("publish", {"topic": "a b", "msg": {}}, "a b"),
        ("advertise", {"topic": "/a", "type": "std_msgs/Nothing"}, "std_msgs/msg/Nothing"),
        ("advertise", {"topic": "/a", "type": "../etc/passwd"}, "not the name of a type"),
        ("advertise", {"topic": "/a", "type": "std_srvs/srv/Empty"}, "not the name of a type"),
        ("advertise", {"topic": "/rosout", "type": "std_msgs/String"}, "has the type rcl_inter"),
        ("subscribe", {"topic": "/unknown"}, "nobody uses /unknown"),
        ("subscribe", {"topic": "/rosout", "type": "std_msgs/String"}, "has the type rcl_interf"),
        ("subscribe", {"topic": "/rosout", "throttle_rate": "5"}, "'throttle_rate' must be"),
        ("service_response", {"service": "/a"}, "you do not serve /a"),
        ("action_feedback", {"action": "/a"}, "you do not serve /a"),
        ("action_result", {"action": "/a"}, "you do not serve /a"),
        ("cancel_action_goal", {"action": "/a"}, "you have no goal"),
        ("unadvertise_service", {"service": "/a"}, "you do not serve /a"),
        ("unadvertise_action", {"action": "/a"}, "you do not serve /a"),
        ("set_level", {"level": "loud"}, "'loud' is not one of"),
        ("fragment", {"num": 0, "total": 1, "data": "{}"}, "needs an id"),
    ],
)
def test_a_wrong_message_is_a_status_and_the_next_one_works(
    web: WebProgram, op: str, fields: dict[str, Any], reason: str
) -> None:
    web.send(op, **{"id": "wrong", **fields}) if op != "fragment" else web.send(op, **fields)
    status = web.wait_for("status")
    assert status["level"] == "error"
    assert reason in status["msg"]
    assert web.call("/rosapi/nodes")["nodes"] == ["/rosbridge_websocket"]


def test_status_levels(web: WebProgram) -> None:
    web.send("unsubscribe", topic="/a")
    web.send("set_level", level="warning")
    web.send("unsubscribe", topic="/a")
    web.send("advertise", topic="/a", type="std_msgs/String")
    web.send("set_level", level="info")
    web.send("advertise", topic="/b", type="std_msgs/String", id=5)
    web.send("set_level", level="none")
    web.send("dance")
    levels = [answer["level"] for answer in web.read()]
    assert levels == ["warning", "info"]
    assert web.received[1]["id"] == 5


def test_fragments_are_joined(web: WebProgram) -> None:
    text = json.dumps({"op": "call_service", "service": "/rosapi/get_time", "id": "t"})
    web.send("fragment", id="f", num=1, total=2, data=text[9:])
    web.send("fragment", id="f", num=0, total=2, data=text[:9])
    assert web.wait_for("service_response", id="t")["values"]["time"]["sec"] > 0
