"""Messages and calls between zbot in ROS 2's dialect and a node that knows only the wire."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from tests.integration.conftest import lines_about
from tests.integration.rmw.ros2_node import ADD, LATCHED, STRING, Ros2Node, string, text_of
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.wire.tokens import gid_of

from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

if TYPE_CHECKING:
    import zbot
    from tests.conftest import Spin
    from tests.integration.rmw.conftest import MakeNode, MakePlain
    from zbot.log.record import Record

LATCHED_PROFILE = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
REQUEST = b"\0\1\0\0" + struct.pack("<qq", 40, 2)


def test_a_node_of_ros_2_gets_messages_with_the_number_and_gid_of_the_token(
    plain: Ros2Node, node: zbot.Node
) -> None:
    samples = plain.subscribe("/chatter")
    publisher = node.create_publisher(String, "chatter", 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    for text in ("one", "two"):
        publisher.publish(String(data=text))
    assert wait_until(lambda: len(samples) == 2)
    assert [sample.payload.to_bytes() for sample in samples] == [string("one"), string("two")]
    facts = [sample.attachment.to_bytes() for sample in samples]
    assert [struct.unpack("<qqB", attachment[:17])[::2] for attachment in facts] == [
        (1, 16),
        (2, 16),
    ]
    assert wait_until(lambda: any("%chatter" in announced for announced in plain.tokens()))
    (token,) = [
        announced for announced in plain.tokens() if "/MP/" in announced and "%chatter" in announced
    ]
    assert {attachment[17:] for attachment in facts} == {gid_of(token)}
    assert str(samples[0].encoding) == "zenoh/bytes"


def test_a_subscription_gets_messages_of_ros_2(
    plain: Ros2Node, node: zbot.Node, spin: Spin
) -> None:
    heard: list[tuple[str, Any]] = []
    subscription = node.create_subscription(
        String, "chatter", lambda msg, info: heard.append((msg.data, info)), 10
    )
    spin(node)
    publisher = plain.publisher("/chatter")
    assert wait_until(lambda: subscription.get_publisher_count() == 1)
    publisher.put(string("héé€") + b"garbage", attachment=plain.attachment())
    assert wait_until(lambda: bool(heard))
    text, info = heard[0]
    assert text == "héé€"
    assert info["publication_sequence_number"] == 1
    assert info["publisher_gid"] == {
        "implementation_identifier": "rmw_zenoh_cpp",
        "data": plain.gid,
    }


@pytest.mark.parametrize("attachment", [None, b"sequence_number" + bytes(60)])
def test_a_message_without_the_attachment_of_ros_2_is_refused_with_a_sentence(
    plain: Ros2Node,
    node: zbot.Node,
    spin: Spin,
    logged: list[Record],
    attachment: bytes | None,
) -> None:
    heard: list[String] = []
    subscription = node.create_subscription(String, "chatter", heard.append, 10)
    spin(node)
    publisher = plain.publisher("/chatter")
    assert wait_until(lambda: subscription.get_publisher_count() == 1)
    for _ in range(2):
        publisher.put(string("x"), attachment=attachment)
    assert wait_until(lambda: subscription.refused_count == 2)
    (line,) = lines_about(logged, "rmw_zenoh needs 33 bytes")
    assert line.startswith("/chatter: cannot read a message: it has ")
    assert heard == []


def test_latched_messages_reach_a_late_node_of_ros_2(
    router: str, make_node: MakeNode, make_plain: MakePlain
) -> None:
    assert router
    publisher = make_node().create_publisher(String, "map", LATCHED_PROFILE)
    for number in range(5):
        publisher.publish(String(data=str(number)))
    plain = make_plain()
    # Zenoh asks each publisher for its history once, as soon as it sees the publisher. On a busy
    # machine, this may be before the link is complete.
    assert wait_until(lambda: any("/MP/" in token and "%map" in token for token in plain.tokens()))
    samples = plain.subscribe("/map", qos=LATCHED)
    assert wait_until(lambda: len(samples) == 3)
    assert [text_of(sample.payload.to_bytes()) for sample in samples] == ["2", "3", "4"]


def test_a_late_subscription_gets_latched_messages_of_ros_2(
    plain: Ros2Node, make_node: MakeNode, spin: Spin
) -> None:
    publisher = plain.publisher("/map", qos=LATCHED)
    for number in range(5):
        publisher.put(string(str(number)), attachment=plain.attachment())
    heard: list[str] = []
    node = make_node()
    node.create_subscription(String, "map", lambda msg: heard.append(msg.data), LATCHED_PROFILE)
    spin(node)
    assert wait_until(lambda: len(heard) == 3)
    assert heard == ["2", "3", "4"]


def test_a_client_calls_a_server_of_ros_2(plain: Ros2Node, node: zbot.Node) -> None:
    seen = plain.serve_sum("/add")
    client = node.create_client(AddTwoInts, "add")
    assert client.wait_for_service(10)
    assert [client.call(AddTwoInts.Request(a=a, b=2), 10).sum for a in (40, 41)] == [42, 43]
    assert [struct.unpack("<q", attachment[:8])[0] for attachment in seen] == [1, 2]
    assert wait_until(lambda: any("/SC/" in announced for announced in plain.tokens()))
    (token,) = [announced for announced in plain.tokens() if "/SC/" in announced]
    assert {attachment[17:] for attachment in seen} == {gid_of(token)}


def test_a_server_answers_a_client_of_ros_2(plain: Ros2Node, node: zbot.Node, spin: Spin) -> None:
    def add(request: Any, response: Any) -> Any:
        response.sum = request.a + request.b
        return response

    node.create_service(AddTwoInts, "add", add)
    spin(node)
    key = plain.announce("SC", "/add", ADD)
    assert wait_until(lambda: any("/SS/" in token and "%add/" in token for token in plain.tokens()))
    (reply,) = plain.call(key, REQUEST, plain.attachment(7))
    assert reply.ok is not None
    assert reply.ok.payload.to_bytes() == b"\0\1\0\0" + struct.pack("<q", 42)
    assert reply.ok.attachment is not None
    facts = reply.ok.attachment.to_bytes()
    assert struct.unpack("<q", facts[:8]) == (7,)
    assert facts[17:] == plain.gid


def test_a_request_without_attachment_is_refused_with_a_sentence(
    plain: Ros2Node, node: zbot.Node, spin: Spin
) -> None:
    node.create_service(AddTwoInts, "add", lambda _, response: response)
    spin(node)
    key = plain.announce("SC", "/add", ADD)
    assert wait_until(lambda: any("/SS/" in token and "%add/" in token for token in plain.tokens()))
    (reply,) = plain.call(key, REQUEST, None)
    assert reply.err is not None
    assert "it has no attachment" in reply.err.payload.to_bytes().decode()


def test_the_tokens_of_a_node_are_those_of_ros_2(plain: Ros2Node, node: zbot.Node) -> None:
    node.create_publisher(String, "~/text", 10)
    zid = node.context.zid
    head = f"@ros2_lv/{plain.domain}/{zid}/0"
    assert wait_until(lambda: any("%robot%text" in token for token in plain.tokens()))
    own = [token for token in plain.tokens() if zid in token]
    assert f"{head}/0/NN/%/%/robot" in own
    assert f"{head}/10/MP/%/%/robot/%robot%text/{'/'.join(STRING)}/::,10:,:,:,," in own
    rosout = [token for token in own if "%rosout" in token]
    assert [token.rpartition("/")[2] for token in rosout] == [":1:,1000:,:10,0:,,"]
    assert len(own) == 11


def test_two_contexts_of_one_process_speak_different_dialects(
    plain: Ros2Node, make_node: MakeNode, spin: Spin
) -> None:
    ours, theirs = make_node("bridge", "rmw_zbot_zenoh"), make_node("bridge", "rmw_zenoh_cpp")
    far = make_node("far", "rmw_zbot_zenoh")
    out = theirs.create_publisher(String, "chatter", 10)
    ours.create_subscription(String, "chatter", out.publish, 10)
    spin(ours)
    samples = plain.subscribe("/chatter")
    assert wait_until(lambda: out.get_subscription_count() == 1)
    far.create_publisher(String, "chatter", 10).publish(String(data="over the bridge"))
    assert wait_until(lambda: bool(samples))
    assert text_of(samples[0].payload.to_bytes()) == "over the bridge"
