"""Tests of publishers and subscriptions that are destroyed."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.integration.conftest import KEEP_ALL, await_match
from zbot.errors import InvalidHandleError

from std_msgs.msg import Int64, String

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.conftest import MakeContext, Spin


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


@pytest.mark.parametrize("how", ["shutdown", "destroy"])
def test_the_end_does_not_wait_for_messages_that_nobody_takes(
    talker: zbot.Node, listener: zbot.Node, how: str
) -> None:
    subscription = listener.create_subscription(Int64, "backlog", print, KEEP_ALL)
    publisher = talker.create_publisher(Int64, "backlog", KEEP_ALL)
    await_match(publisher)
    for number in range(20):
        publisher.publish(Int64(data=number))
    assert wait_until(lambda: subscription.has_work)
    begin = time.monotonic()
    if how == "shutdown":
        listener.context.shutdown()
    else:
        listener.destroy_subscription(subscription)
    assert time.monotonic() - begin < allowed(1.0)


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
    with pytest.raises(RuntimeError, match=r"(zbot|rclpy)\.init\(\)"):
        publisher.publish(String())


def test_the_first_publish_after_shutdown_raises(talker: zbot.Node) -> None:
    publisher = talker.create_publisher(String, "chatter", 10)
    talker.context.shutdown()
    with pytest.raises(RuntimeError, match=r"(zbot|rclpy)\.init\(\)"):
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


@contextmanager
def traffic(publisher: zbot.Publisher[Int64], number: int, pause_s: float) -> Iterator[None]:
    """Publish some messages after each pause, in a thread."""
    stop = threading.Event()

    def publish() -> None:
        while not stop.wait(pause_s):
            for _ in range(number):
                publisher.publish(Int64())

    thread = threading.Thread(target=publish)
    thread.start()
    try:
        yield
    finally:
        stop.set()
        thread.join()


@pytest.mark.parametrize(
    ("rounds", "number", "pause_s"), [(20, 1, 0), (100, 2, 0.002)], ids=["flood", "pairs"]
)
def test_destroying_under_traffic_is_clean(
    talker: zbot.Node, listener: zbot.Node, spin: Spin, rounds: int, number: int, pause_s: float
) -> None:
    publisher = talker.create_publisher(Int64, "count", 10)
    spinner = spin(listener)
    destroyed = []
    with traffic(publisher, number, pause_s):
        for _ in range(rounds):
            got = threading.Event()
            subscription = listener.create_subscription(Int64, "count", lambda _, g=got: g.set(), 5)
            assert got.wait(5), spinner.error
            listener.destroy_subscription(subscription)
            destroyed.append(subscription)
    # Nobody looks for more messages.
    assert wait_until(lambda: all(subscription.due_ns is None for subscription in destroyed), 5)
    assert spinner.error is None


def test_a_node_that_fails_in_its_constructor_leaves_the_graph(make_context: MakeContext) -> None:
    context = make_context()
    with pytest.raises(zbot.errors.ZbotError, match="use_sim_time"):
        zbot.Node(
            "arm", context=context, parameter_overrides=[zbot.Parameter("use_sim_time", value=1)]
        )
    assert context.nodes == []
    observer = zbot.Node("observer", context=context)
    assert observer.get_node_names() == ["observer"]
