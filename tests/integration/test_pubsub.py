"""Tests of messages between two contexts of one process, over Zenoh."""

from __future__ import annotations

import subprocess
import sys
import threading
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import msgpack  # type: ignore[import-untyped]
import pytest

import zbot
from tests.conftest import wait_until
from tests.integration.conftest import await_match, lines_about, packed
from zbot.errors import InvalidHandleError
from zbot.executor.errors import CallbackSignatureError
from zbot.node.errors import MessageTypeError
from zbot.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from zbot.wire.serialization import deserialize_message, serialize_message

from rcl_interfaces.msg import Log
from std_msgs.msg import Float32, Int64, String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Spin
    from zbot.log.record import Record

LATCHED = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)
KEEP_ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)
BEST_EFFORT = QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)


# -- acknowledgements ------------------------------------------------------------------------------


def test_messages_to_another_session_are_not_known_to_be_acknowledged(
    talker: zbot.Node, listener: zbot.Node
) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    listener.create_subscription(String, "chatter", print, 10)
    await_match(publisher)
    assert publisher.wait_for_all_acked(zbot.Duration(seconds=1))  # nothing was published
    publisher.publish(String(data="hi"))
    assert not publisher.wait_for_all_acked(zbot.Duration(seconds=1))
    assert not publisher.wait_for_all_acked()
    listener.destroy_node()
    await_match(publisher, 0)
    assert publisher.wait_for_all_acked()


@pytest.mark.parametrize(
    ("offered", "requested"), [(BEST_EFFORT, KEEP_ALL), (KEEP_ALL, BEST_EFFORT)]
)
def test_best_effort_needs_no_acknowledgement(
    offered: QoSProfile, requested: QoSProfile, talker: zbot.Node, listener: zbot.Node
) -> None:
    publisher = talker.create_publisher(String, "chatter", offered)
    listener.create_subscription(String, "chatter", print, requested)
    await_match(publisher)
    publisher.publish(String(data="hi"))
    assert publisher.wait_for_all_acked()


def test_a_subscription_of_the_same_context_acknowledges_at_once(talker: zbot.Node) -> None:
    subscription = talker.create_subscription(String, "chatter", print, 10)
    publisher = talker.create_publisher(String, "chatter", 10)
    await_match(publisher)
    publisher.publish(String(data="hi"))
    assert publisher.wait_for_all_acked()
    assert wait_until(lambda: subscription.has_work, timeout_s=2)


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


def test_messages_of_other_domains_are_ignored(talker: zbot.Node, domain: int, spin: Spin) -> None:
    other = zbot.Context()
    other.init([], domain_id=domain % 232 + 1 if domain < 231 else 1)
    with other:
        stranger = zbot.Node("stranger", context=other)
        inbox: list[String] = []
        talker.create_subscription(String, "chatter", inbox.append, 10)
        spin(talker)
        stranger.create_publisher(String, "chatter", 10).publish(String(data="other"))
        talker.create_publisher(String, "chatter", 10).publish(String(data="own"))
        assert wait_until(lambda: bool(inbox))
        assert [message.data for message in inbox] == ["own"]


# -- history ---------------------------------------------------------------------------------------


def test_keep_last_drops_the_oldest_message_with_one_warning(
    talker: zbot.Node, listener: zbot.Node, logged: list[Record]
) -> None:
    inbox: list[Int64] = []
    subscription = listener.create_subscription(Int64, "count", inbox.append, 5)
    mark = listener.create_subscription(String, "mark", lambda _: None, 1)
    publisher = talker.create_publisher(Int64, "count", KEEP_ALL)
    marker = talker.create_publisher(String, "mark", KEEP_ALL)
    await_match(marker)
    executor = zbot.SingleThreadedExecutor(context=listener.context)
    executor.add_node(listener)
    publisher.publish(Int64(data=-1))
    while not inbox:
        executor.spin_once(timeout_sec=2)
    for first in (0, 100):
        for number in range(first, first + 100):
            publisher.publish(Int64(data=number))
        marker.publish(String())
        # Zenoh keeps the order on a link: the burst has arrived before the mark.
        assert wait_until(lambda: mark._is_waiting)
        inbox.clear()
        while len(inbox) < 5 or mark._is_waiting:
            executor.spin_once(timeout_sec=2)
        assert [message.data for message in inbox] == list(range(first + 95, first + 100))
    assert subscription.lost_count == 190
    assert len(lines_about(logged, "messages lost")) == 1
    assert "/count: 95 messages lost" in lines_about(logged, "messages lost")[0]


def test_a_loss_on_rosout_is_not_logged_on_rosout(listener: zbot.Node) -> None:
    inbox: list[str] = []
    subscription = listener.create_subscription(
        Log, "/rosout", lambda line: inbox.append(line.msg), 1
    )
    logger = listener.get_logger()
    executor = zbot.SingleThreadedExecutor(context=listener.context)
    executor.add_node(listener)
    for lines in (["first"], ["a", "b", "c"], ["last"]):
        for line in lines:
            logger.info(line)
        while inbox[-1:] != lines[-1:]:
            executor.spin_once(timeout_sec=2)
    assert (inbox, subscription.lost_count) == (["first", "c", "last"], 2)


def test_a_subscription_knows_the_arguments_of_its_callback(listener: zbot.Node) -> None:
    kinds = zbot.Subscription.CallbackType
    for callback, kind in (
        (lambda _: None, kinds.MessageOnly),
        (lambda _, __: None, kinds.WithMessageInfo),
    ):
        subscription = listener.create_subscription(String, "chatter", callback, 1)
        assert subscription._callback_type is kind


def test_keep_all_loses_nothing_in_a_flood(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    count = 20_000
    numbers: list[int] = []
    subscription = listener.create_subscription(
        Int64, "count", lambda message: numbers.append(message.data), KEEP_ALL
    )
    publisher = talker.create_publisher(Int64, "count", KEEP_ALL)
    await_match(publisher)
    spin(listener)
    for number in range(count):
        publisher.publish(Int64(data=number))
    assert wait_until(lambda: len(numbers) >= count)
    assert numbers == list(range(count))
    assert subscription.lost_count == 0


def test_messages_of_several_threads_keep_the_order_of_their_numbers(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    numbers: list[int] = []
    subscription = listener.create_subscription(
        String,
        "words",
        lambda _, info: numbers.append(info["publication_sequence_number"]),
        KEEP_ALL,
    )
    publisher = talker.create_publisher(String, "words", KEEP_ALL)
    await_match(publisher)
    spin(listener)

    def speak() -> None:
        for _ in range(2000):
            publisher.publish(String(data="word"))

    speak()
    threads = [threading.Thread(target=speak) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wait_until(lambda: len(numbers) == 8000)
    assert numbers == list(range(1, 8001))
    assert subscription.lost_count == 0


def test_an_overtaken_message_does_not_count_later_ones_as_lost(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    arrived: list[String] = []
    subscription = listener.create_subscription(String, "words", arrived.append, 10)
    publisher = talker.create_publisher(String, "words", 10)
    await_match(publisher)
    spin(listener)
    numbers = iter([1, 2, 4, 3, 5, 6])
    publisher._next_number = numbers.__next__
    for _ in range(6):
        publisher.publish(String(data="word"))
    assert wait_until(lambda: len(arrived) == 6)
    assert subscription.lost_count == 1


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


def test_a_burst_that_fits_into_the_queue_arrives_whole(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    arrived: list[String] = []
    listener.create_subscription(String, "burst", arrived.append, 3000)
    publisher = talker.create_publisher(String, "burst", 3000)
    await_match(publisher)
    spin(listener)
    message = String(data="x" * 3000)
    busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        for _ in range(3000):
            publisher.publish(message)
        assert wait_until(lambda: len(arrived) == 3000)
    finally:
        busy.kill()
        busy.wait()


def test_a_latched_topic_delivers_its_last_messages_to_late_subscriptions(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    publisher = talker.create_publisher(Int64, "map", LATCHED)
    for number in range(5):
        publisher.publish(Int64(data=number))
    spin(listener)
    inbox: list[Int64] = []
    listener.create_subscription(Int64, "map", inbox.append, LATCHED)
    assert wait_until(lambda: len(inbox) == 3)
    publisher.publish(Int64(data=5))
    assert wait_until(lambda: len(inbox) == 4)
    assert [message.data for message in inbox] == [2, 3, 4, 5]


def test_a_volatile_subscription_of_a_latched_topic_gets_only_new_messages(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    publisher = talker.create_publisher(Int64, "map", LATCHED)
    publisher.publish(Int64(data=0))
    spin(listener)
    inbox: list[Int64] = []
    listener.create_subscription(Int64, "map", inbox.append, 10)
    await_match(publisher)
    publisher.publish(Int64(data=1))
    assert wait_until(lambda: bool(inbox))
    assert [message.data for message in inbox] == [1]


def test_an_expired_message_is_not_delivered(
    talker: zbot.Node, listener: zbot.Node, monkeypatch: pytest.MonkeyPatch
) -> None:
    inbox: list[Int64] = []
    short = QoSProfile(depth=10, lifespan=zbot.Duration(seconds=1))
    listener.create_subscription(Int64, "count", inbox.append, short)
    publisher = talker.create_publisher(Int64, "count", 10)
    executor = zbot.SingleThreadedExecutor(context=listener.context)
    executor.add_node(listener)
    with monkeypatch.context() as patch:
        patch.setattr("zbot.node.publisher.time_ns", lambda: 10**9)
        publisher.publish(Int64(data=0))
    publisher.publish(Int64(data=1))
    while not inbox:
        executor.spin_once(timeout_sec=2)
    assert [message.data for message in inbox] == [1]


# -- forms of subscriptions ------------------------------------------------------------------------


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


# -- what publish() takes --------------------------------------------------------------------------


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
    with pytest.raises(MessageTypeError) as raised:
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


# -- the end ---------------------------------------------------------------------------------------


def test_a_callback_may_destroy_its_own_subscription(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    inbox: list[Int64] = []

    def on_message(message: Int64) -> None:
        inbox.append(message)
        listener.destroy_subscription(subscription)

    subscription = listener.create_subscription(Int64, "count", on_message, 10)
    publisher = talker.create_publisher(Int64, "count", 10)
    done: list[String] = []
    listener.create_subscription(String, "done", done.append, 10)
    finish = talker.create_publisher(String, "done", 10)
    await_match(publisher)
    spinner = spin(listener)
    for number in range(5):
        publisher.publish(Int64(data=number))
    finish.publish(String())
    assert wait_until(lambda: bool(done))
    assert len(inbox) == 1
    assert spinner.error is None
    await_match(publisher, 0)


def test_a_callback_may_destroy_its_own_node(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    publisher = talker.create_publisher(Int64, "count", 10)
    listener.create_subscription(Int64, "count", lambda _: listener.destroy_node(), 10)
    await_match(publisher)
    spinner = spin(listener)
    publisher.publish(Int64())
    assert wait_until(lambda: "listener" not in talker.get_node_names())
    assert spinner.error is None


def test_publishing_with_a_destroyed_publisher_raises(talker: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    assert talker.destroy_publisher(publisher)
    assert not talker.destroy_publisher(publisher)
    with pytest.raises(InvalidHandleError, match="/chatter was destroyed"):
        publisher.publish(String())


def test_publishing_after_shutdown_raises(talker: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    publisher.publish(String())
    talker.context.shutdown()
    with pytest.raises(RuntimeError, match=r"zbot\.init\(\)"):
        publisher.publish(String())


def test_the_first_publish_after_shutdown_raises(talker: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    talker.context.shutdown()
    with pytest.raises(RuntimeError, match=r"zbot\.init\(\)"):
        publisher.publish(String())


def test_destroying_twice_is_harmless(talker: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    subscription = talker.create_subscription(String, "chatter", print, 10)
    for _ in range(2):
        publisher.destroy()
        subscription.destroy()
        talker.destroy_node()
        talker.context.shutdown()
    with pytest.raises(InvalidHandleError):
        talker.create_publisher(String, "chatter", 10)


def test_a_nodes_handle_is_valid_until_the_end_of_its_block(talker: zbot.Node) -> None:
    with talker.handle:
        talker.handle.destroy_when_not_in_use()
        with talker.handle:
            pass
    with pytest.raises(InvalidHandleError), talker.handle:
        pass


def test_a_node_destroys_only_its_own_entities(talker: zbot.Node, listener: zbot.Node) -> None:
    foreign = listener.create_publisher(String, "chatter", 10)
    assert not talker.destroy_publisher(foreign)
    assert not talker.destroy_publisher(None)  # type: ignore[arg-type]
    assert not talker.destroy_subscription(None)  # type: ignore[arg-type]
    assert listener.destroy_publisher(foreign)


def test_with_blocks_destroy_their_entities(talker: zbot.Node) -> None:
    with talker.create_publisher(String, "chatter", 10) as publisher:
        assert talker.count_publishers("chatter") == 1
        assert publisher.topic_name == "/chatter"
    assert talker.count_publishers("chatter") == 0
    with talker.create_subscription(String, "chatter", print, 10) as subscription:
        assert talker.count_subscribers("chatter") == 1
        assert subscription.topic_name == "/chatter"
    assert talker.count_subscribers("chatter") == 0


def test_destroying_under_traffic_is_clean(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    publisher = talker.create_publisher(Int64, "count", 10)
    spinner = spin(listener)
    stop = threading.Event()

    def publish() -> None:
        while not stop.is_set():
            publisher.publish(Int64())

    thread = threading.Thread(target=publish)
    thread.start()
    try:
        for _ in range(20):
            got = threading.Event()
            subscription = listener.create_subscription(Int64, "count", lambda _, g=got: g.set(), 5)
            assert got.wait(5), spinner.error
            listener.destroy_subscription(subscription)
    finally:
        stop.set()
        thread.join()
    assert spinner.error is None


# -- counting --------------------------------------------------------------------------------------


def test_counts_follow_the_other_nodes_endpoints(talker: zbot.Node, listener: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    assert publisher.get_subscription_count() == 0
    first = listener.create_subscription(String, "chatter", print, 10)
    second = listener.create_subscription(String, "chatter", print, 10)
    await_match(publisher, 2)
    assert wait_until(lambda: first.get_publisher_count() == 1)
    listener.destroy_subscription(second)
    await_match(publisher, 1)
    listener.context.shutdown()
    await_match(publisher, 0)


def test_endpoints_keep_their_given_names(make_context: MakeContext) -> None:
    node = zbot.Node("named", namespace="/ns", context=make_context())
    publisher = node.create_publisher(String, "~/news", 1)
    subscription = node.create_subscription(String, "news", lambda _: None, 1)
    assert (publisher.topic, publisher.topic_name) == ("~/news", "/ns/named/news")
    assert (subscription.topic, subscription.topic_name) == ("news", "/ns/news")
    client = node.create_client(Trigger, "help")
    service = node.create_service(Trigger, "/help", lambda _, response: response)
    assert (client.srv_name, client.service_name) == ("help", "/ns/help")
    assert (service.srv_name, service.service_name) == ("/help", "/help")


@pytest.mark.parametrize("callback", [None, 5, "hear"])
def test_a_callback_that_is_not_callable_is_refused(listener: zbot.Node, callback: Any) -> None:
    with pytest.raises(CallbackSignatureError, match=r"\(message\) or \(message, info\)"):
        listener.create_subscription(String, "news", callback, 1)
