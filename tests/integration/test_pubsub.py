"""Tests of messages between two contexts of one process, over Zenoh."""

from __future__ import annotations

import contextlib
import threading
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import msgpack  # type: ignore[import-untyped]
import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.conftest import KEEP_ALL, await_match, packed
from zbot.errors import WrongTypeError
from zbot.testing.domain import reserved_domain
from zbot.wire.serialization import deserialize_message, serialize_message

from std_msgs.msg import Float32, Int64, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Spin


# -- delivery --------------------------------------------------------------------------------------


def test_a_message_arrives_unchanged(talker: zbot.Node, listener: zbot.Node, spin: Spin) -> None:
    inbox: list[String] = []
    listener.create_subscription(String, "chatter", inbox.append, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    spin(listener)
    publisher.publish(String(data="grüße"))
    assert wait_until(lambda: bool(inbox))
    assert inbox == [String(data="grüße")]


def test_the_first_message_reaches_an_existing_subscription(
    listener: zbot.Node, make_context: MakeContext, spin: Spin
) -> None:
    inbox: list[Int64] = []
    listener.create_subscription(Int64, "count", inbox.append, 10)
    spin(listener)
    for number in range(5):
        node = zbot.Node("newcomer", context=make_context())
        node.create_publisher(Int64, "count", 10).publish(Int64(data=number))
        node.context.shutdown()
    assert wait_until(lambda: len(inbox) == 5)
    assert [message.data for message in inbox] == [0, 1, 2, 3, 4]


def test_messages_reach_a_subscription_of_the_same_node(talker: zbot.Node, spin: Spin) -> None:
    inbox: list[String] = []
    talker.create_subscription(String, "chatter", inbox.append, 10)
    talker.create_publisher(String, "chatter", 10).publish(String(data="self"))
    spin(talker)
    assert wait_until(lambda: bool(inbox))


def test_every_subscription_of_a_topic_gets_every_message(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    inboxes: list[list[String]] = [[], [], []]
    for inbox in inboxes:
        listener.create_subscription(String, "chatter", inbox.append, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    spin(listener)
    publisher.publish(String(data="all"))
    assert wait_until(lambda: all(len(inbox) == 1 for inbox in inboxes))


def test_messages_wait_for_an_executor(talker: zbot.Node, listener: zbot.Node) -> None:
    inbox: list[Int64] = []
    listener.create_subscription(Int64, "count", inbox.append, 10)
    publisher = talker.create_publisher(Int64, "count", 10)
    for number in range(3):
        publisher.publish(Int64(data=number))
    executor = zbot.SingleThreadedExecutor(context=listener.context)
    executor.add_node(listener)
    while len(inbox) < 3:
        executor.spin_once(timeout_sec=2)
    assert [message.data for message in inbox] == [0, 1, 2]


def test_messages_of_other_domains_are_ignored(talker: zbot.Node, spin: Spin) -> None:
    other = zbot.Context()
    with reserved_domain() as other_domain, contextlib.ExitStack() as stack:
        stack.callback(other.shutdown)
        other.init([], domain_id=other_domain)
        stranger = zbot.Node("stranger", context=other)
        inbox: list[String] = []
        talker.create_subscription(String, "chatter", inbox.append, 10)
        spin(talker)
        stranger.create_publisher(String, "chatter", 10).publish(String(data="other"))
        talker.create_publisher(String, "chatter", 10).publish(String(data="own"))
        assert wait_until(lambda: bool(inbox))
        assert [message.data for message in inbox] == ["own"]


# -- forms of subscriptions ------------------------------------------------------------------------


@pytest.mark.own_dialect("it reads a message in zbot's own form")
def test_a_raw_subscription_receives_the_sent_bytes(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    inbox: list[bytes] = []
    listener.create_subscription(String, "chatter", inbox.append, 10, raw="payload")
    publisher = talker.create_publisher(String, "chatter", 10)
    spin(listener)
    publisher.publish(String(data="raw"))
    publisher.publish(b"\xc1 not MessagePack")
    assert wait_until(lambda: len(inbox) == 2)
    assert msgpack.unpackb(inbox[0]) == {"data": "raw"}
    assert inbox[1] == b"\xc1 not MessagePack"


def test_raw_messages_are_cdr_both_ways(talker: zbot.Node, listener: zbot.Node, spin: Spin) -> None:
    inbox: list[bytes] = []
    read: list[String] = []
    listener.create_subscription(String, "chatter", inbox.append, 10, raw=True)
    listener.create_subscription(String, "chatter", read.append, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    spin(listener)
    publisher.publish(String(data="raw"))
    publisher.publish(serialize_message(String(data="sent")))
    assert wait_until(lambda: len(inbox) == len(read) == 2)
    assert [deserialize_message(data, String).data for data in inbox] == ["raw", "sent"]
    assert [message.data for message in read] == ["raw", "sent"]


def test_a_callback_with_two_arguments_gets_times_and_numbers(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    infos: list[dict[str, int]] = []
    listener.create_subscription(String, "chatter", lambda _, info: infos.append(info), 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    before = talker.get_clock().now().nanoseconds
    spin(listener)
    publisher.publish(String())
    publisher.publish(String())
    assert wait_until(lambda: len(infos) == 2)
    assert [info["publication_sequence_number"] for info in infos] == [1, 2]
    assert [info["reception_sequence_number"] for info in infos] == [1, 2]
    for info in infos:
        assert before <= info["source_timestamp"] <= info["received_timestamp"]


@pytest.mark.parametrize("callback", [lambda: None, lambda a, b, c: None])  # noqa: ARG005
def test_a_callback_with_a_wrong_signature_is_refused(
    talker: zbot.Node, callback: Callable[..., None]
) -> None:
    with pytest.raises(RuntimeError, match=r"\(message\) or \(message, info\)"):
        talker.create_subscription(String, "chatter", callback, 10)


def test_a_refused_subscription_is_not_in_the_graph(talker: zbot.Node) -> None:
    with pytest.raises(RuntimeError):
        talker.create_subscription(String, "chatter", lambda: None, 10)
    assert talker.count_subscribers("chatter") == 0


@pytest.mark.parametrize("callback", [None, 5, "hear"])
def test_a_callback_that_is_not_callable_is_refused(listener: zbot.Node, callback: Any) -> None:
    with pytest.raises(WrongTypeError, match="create_subscription was given"):
        listener.create_subscription(String, "news", callback, 1)


# -- calls of publish() ----------------------------------------------------------------------------


def test_a_signal_handler_may_publish_on_the_interrupted_publisher(
    talker: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    publisher = talker.create_publisher(String, "words", 10)
    handlers = iter([lambda: publisher.publish(String(data="stop"))])

    def interrupted() -> None:
        next(handlers, bool)()

    monkeypatch.setattr(talker.context, "wait_for_peers", interrupted)
    publisher.publish(String(data="go"))
    assert publisher.sent_count == 2


def test_bytes_are_published_unchanged(talker: zbot.Node, listener: zbot.Node, spin: Spin) -> None:
    inbox: list[String] = []
    listener.create_subscription(String, "chatter", inbox.append, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    spin(listener)
    publisher.publish(packed({"data": "packed"}))
    assert wait_until(lambda: inbox == [String(data="packed")])


@pytest.mark.parametrize("wrong", [Float32(data=1.0), "text", None, String, 1, {"data": "x"}])
def test_publishing_another_type_names_both(talker: zbot.Node, wrong: Any) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    with pytest.raises(WrongTypeError) as raised:
        publisher.publish(wrong)
    assert "/chatter carries std_msgs/msg/String" in str(raised.value)
    assert isinstance(raised.value, TypeError)
    assert publisher.sent_count == 0


def test_a_subclass_of_the_type_is_published(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    class Loud(String):
        pass

    inbox: list[String] = []
    listener.create_subscription(String, "chatter", inbox.append, 10)
    spin(listener)
    talker.create_publisher(String, "chatter", 10).publish(Loud(data="LOUD"))
    assert wait_until(lambda: bool(inbox))
    assert inbox[0].data == "LOUD"


def test_many_threads_may_publish_at_once(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    numbers: list[int] = []
    infos: list[int] = []

    def on_message(message: Int64, info: dict[str, int]) -> None:
        numbers.append(message.data)
        infos.append(info["publication_sequence_number"])

    listener.create_subscription(Int64, "count", on_message, KEEP_ALL)
    publisher = talker.create_publisher(Int64, "count", KEEP_ALL)
    await_match(publisher)
    spin(listener)

    def publish(first: int) -> None:
        for number in range(first, first + 250):
            publisher.publish(Int64(data=number))

    threads = [threading.Thread(target=publish, args=(1000 * k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wait_until(lambda: len(numbers) == 2000)
    assert sorted(infos) == list(range(1, 2001))
    # One message may be overtaken: the one that the first thread has just begun.
    assert sum(later < sooner for sooner, later in pairwise(infos)) <= 1
    assert len(set(numbers)) == 2000
