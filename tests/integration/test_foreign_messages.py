"""Tests of messages that other Zenoh programs send to a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from tests.integration.conftest import await_match, lines_about, packed
from zbot.qos import HistoryPolicy, QoSProfile

from std_msgs.msg import Float32, String

if TYPE_CHECKING:
    import zbot
    from tests.conftest import Spin
    from zbot.log.record import Record

pytestmark = pytest.mark.own_dialect("it sends messages in zbot's own form")

KEEP_ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)


def put(node: zbot.Node, key: str, payload: Any, encoding: str | None = None) -> None:
    """Publish as a plain Zenoh program does, without an attachment."""
    zenoh_key = f"{node.context.get_domain_id()}{key}"
    node.context.session.put(zenoh_key, payload, encoding=encoding)


def test_invalid_bytes_are_one_log_line_and_the_next_message_arrives(
    talker: zbot.Node,
    listener: zbot.Node,
    spin: Spin,
    logged: list[Record],
) -> None:
    inbox: list[String] = []
    subscription = listener.create_subscription(String, "chatter", inbox.append, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    await_match(publisher)
    spinner = spin(listener)
    for _ in range(2):
        put(talker, "/chatter", b"plain text", "text/plain")
    publisher.publish(String(data="good"))
    assert wait_until(lambda: bool(inbox))
    assert inbox == [String(data="good")]
    assert subscription.refused_count == 2
    assert len(lines_about(logged, "/chatter: cannot read a message")) == 1
    assert spinner.error is None


def test_a_plain_put_without_attachment_is_accepted(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    inbox: list[tuple[String, dict[str, int]]] = []
    listener.create_subscription(
        String, "chatter", lambda message, info: inbox.append((message, info)), 10
    )
    publisher = talker.create_publisher(String, "chatter", 10)
    await_match(publisher)
    spin(listener)
    put(talker, "/chatter", packed({"data": "plain"}))
    assert wait_until(lambda: bool(inbox))
    message, info = inbox[0]
    assert message.data == "plain"
    assert (info["source_timestamp"], info["publication_sequence_number"]) == (0, 0)


def test_a_delete_is_not_a_message(talker: zbot.Node, listener: zbot.Node, spin: Spin) -> None:
    inbox: list[String] = []
    listener.create_subscription(String, "chatter", inbox.append, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    await_match(publisher)
    spinner = spin(listener)
    talker.context.session.delete(f"{talker.context.get_domain_id()}/chatter")
    publisher.publish(String(data="after"))
    assert wait_until(lambda: bool(inbox))
    assert [message.data for message in inbox] == ["after"]
    assert spinner.error is None


def test_two_types_on_one_topic_do_not_mix_and_are_logged_once(
    talker: zbot.Node, listener: zbot.Node, spin: Spin, logged: list[Record]
) -> None:
    inbox: list[String] = []
    subscription = listener.create_subscription(String, "chatter", inbox.append, 10)
    wrong = talker.create_publisher(Float32, "chatter", 10)
    right = talker.create_publisher(String, "chatter", 10)
    spin(listener)
    for _ in range(3):
        wrong.publish(Float32(data=1.0))
    right.publish(String(data="good"))
    assert wait_until(lambda: bool(inbox))
    assert inbox == [String(data="good")]
    assert subscription.received_count == 1
    assert subscription.refused_count == 3
    assert len(lines_about(logged, "it is std_msgs/msg/Float32, not std_msgs/msg/String")) == 1
