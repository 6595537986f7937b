"""Tests of the history of a topic: messages that are kept or lost."""

from __future__ import annotations

import subprocess
import sys
import threading
from typing import TYPE_CHECKING

import zbot
from tests.conftest import wait_until
from tests.integration.conftest import KEEP_ALL, await_match, lines_about
from zbot.qos import DurabilityPolicy, QoSProfile

from std_msgs.msg import Int64, String

if TYPE_CHECKING:
    from tests.conftest import Spin
    from zbot.log.record import Record

LATCHED = QoSProfile(depth=3, durability=DurabilityPolicy.TRANSIENT_LOCAL)


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
        assert wait_until(lambda: mark.has_work)
        inbox.clear()
        while len(inbox) < 5 or mark.has_work:
            executor.spin_once(timeout_sec=2)
        assert [message.data for message in inbox] == list(range(first + 95, first + 100))
    assert subscription.lost_count == 190
    assert len(lines_about(logged, "messages lost")) == 1
    assert "/count: 95 messages lost" in lines_about(logged, "messages lost")[0]


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


def test_a_destroyed_latched_subscription_asks_no_publisher_for_its_past(
    talker: zbot.Node, listener: zbot.Node, spin: Spin
) -> None:
    for _ in range(3):
        listener.destroy_subscription(
            listener.create_subscription(Int64, "map", lambda _: None, LATCHED)
        )
    # The keys of the caches of the topic's publishers.
    key = f"{talker.context.get_domain_id()}/map/@adv/pub/**"
    asked: list[str] = []
    queryable = talker.context.session.declare_queryable(
        key, lambda query: asked.append(str(query.key_expr))
    )
    publisher = talker.create_publisher(Int64, "map", LATCHED)
    publisher.publish(Int64(data=1))
    spin(listener)
    inbox: list[Int64] = []
    listener.create_subscription(Int64, "map", inbox.append, LATCHED)
    assert wait_until(lambda: bool(inbox))
    queryable.undeclare()
    # The living subscription asks all publishers at first, and each publisher that it learns of.
    assert 1 <= len(asked) <= 2


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
