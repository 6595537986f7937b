"""Tests of entities that are destroyed and created again. They get the former key and gid."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import zbot
from tests.conftest import wait_until
from zbot.qos import DurabilityPolicy, QoSProfile

from std_msgs.msg import Int64
from std_srvs.srv import SetBool

if TYPE_CHECKING:
    from tests.conftest import MakeContext, Spin
    from zbot.graph.snapshot import Token

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
CYCLES = 30


def keys_of(node: zbot.Node) -> set[str]:
    return {
        token.key for token in node.context.graph.snapshot().tokens if token.zid == node.context.zid
    }


def test_an_equal_entity_of_a_session_has_the_same_key(make_context: MakeContext) -> None:
    node = zbot.Node("maker", context=make_context())

    def make() -> set[str]:
        before = keys_of(node)
        other = zbot.Node("other", context=node.context)
        other.create_publisher(Int64, "numbers", 10)
        other.create_subscription(Int64, "numbers", print, LATCHED)
        other.create_service(SetBool, "switch", print)
        other.create_client(SetBool, "switch")
        made = keys_of(node) - before
        other.destroy_node()
        assert keys_of(node) == before
        return made

    first = make()
    assert len(first) > 5
    assert make() == first


def test_others_see_an_equal_entity_that_comes_immediately(make_context: MakeContext) -> None:
    node = zbot.Node("maker", context=make_context())
    watcher = zbot.Node("watcher", context=make_context())
    watcher.get_topic_names_and_types()
    for _ in range(CYCLES):
        node.destroy_publisher(node.create_publisher(Int64, "numbers", 10))
    publisher = node.create_publisher(Int64, "numbers", 10)
    node.create_publisher(Int64, "last", 10)  # the watcher knows the others when it knows this one
    assert wait_until(lambda: watcher.count_publishers("last") == 1)
    assert watcher.count_publishers("numbers") == 1
    assert node.count_publishers("numbers") == 1
    (info,) = watcher.get_publishers_info_by_topic("/numbers")
    assert bytes(info.endpoint_gid)[:16] == publisher.token.gid
    node.destroy_publisher(publisher)
    assert wait_until(lambda: watcher.count_publishers("numbers") == 0)


def test_the_own_graph_is_right_while_late_samples_of_zenoh_arrive(
    make_context: MakeContext,
) -> None:
    node = zbot.Node("maker", context=make_context())
    node.get_topic_names_and_types()
    changes: list[tuple[str, bool]] = []

    class Listener:
        def note(self, token: Token, appeared: bool) -> None:
            if getattr(token, "name", "") == "/numbers":
                changes.append((token.key, appeared))

    listener = Listener()
    node.context.graph.add_listener(listener.note)
    for _ in range(CYCLES):
        publisher = node.create_publisher(Int64, "numbers", 10)
        assert node.count_publishers("numbers") == 1
        node.destroy_publisher(publisher)
        assert node.count_publishers("numbers") == 0
    assert [appeared for _, appeared in changes] == [True, False] * CYCLES
    assert len({key for key, _ in changes}) == 1


def test_the_messages_of_an_equal_publisher_are_not_counted_as_lost(
    make_context: MakeContext, spin: Spin
) -> None:
    node = zbot.Node("maker", context=make_context())
    listener = zbot.Node("listener", context=make_context())
    numbers: list[int] = []

    def hear(message: Int64, info: Any) -> None:
        numbers.append(info["publication_sequence_number"])
        assert message.data == numbers[-1]

    subscription = listener.create_subscription(Int64, "numbers", hear, 100)
    spin(listener)
    for number in range(1, 11):
        publisher = node.create_publisher(Int64, "numbers", 10)
        assert wait_until(lambda publisher=publisher: publisher.get_subscription_count() == 1)  # type: ignore[misc]
        publisher.publish(Int64(data=number))
        assert wait_until(lambda number=number: len(numbers) == number)  # type: ignore[misc]
        node.destroy_publisher(publisher)
    assert numbers == list(range(1, 11))
    assert subscription.lost_count == 0


def test_the_call_of_an_equal_client_is_not_taken_for_a_repeated_call(
    make_context: MakeContext, spin: Spin
) -> None:
    node = zbot.Node("caller", context=make_context())
    server = zbot.Node("server", context=make_context())
    heard: list[bool] = []

    def answer(request: Any, response: Any) -> Any:
        heard.append(request.data)
        time.sleep(1.1)  # the server keeps an answer that is late, for a repeated call
        response.success = request.data
        return response

    server.create_service(SetBool, "switch", answer)
    spin(server)
    for value in (True, False):
        client = node.create_client(SetBool, "switch")
        assert client.wait_for_service(10)
        assert client.call(SetBool.Request(data=value)).success is value
        node.destroy_client(client)
    assert heard == [True, False]


def test_a_latched_publisher_does_not_send_the_messages_of_a_former_one(
    make_context: MakeContext, spin: Spin
) -> None:
    node = zbot.Node("maker", context=make_context())
    for _ in range(2):  # the second one gets Zenoh's publisher of the first one
        node.destroy_publisher(node.create_publisher(Int64, "numbers", LATCHED))
    first = node.create_publisher(Int64, "numbers", LATCHED)
    first.publish(Int64(data=1))
    node.destroy_publisher(first)
    second = node.create_publisher(Int64, "numbers", LATCHED)
    listener = zbot.Node("listener", context=make_context())
    heard: list[int] = []
    listener.create_subscription(
        Int64, "numbers", lambda message: heard.append(message.data), LATCHED
    )
    spin(listener)
    assert wait_until(lambda: second.get_subscription_count() == 1)
    second.publish(Int64(data=2))
    assert wait_until(lambda: heard != [])
    assert heard == [2]


def test_a_subscription_that_stays_hears_each_new_latched_publisher(
    make_context: MakeContext, spin: Spin
) -> None:
    node = zbot.Node("maker", context=make_context())
    listener = zbot.Node("listener", context=make_context())
    heard: list[int] = []
    listener.create_subscription(
        Int64, "numbers", lambda message: heard.append(message.data), LATCHED
    )
    spin(listener)
    for number in range(3):
        publisher = node.create_publisher(Int64, "numbers", LATCHED)
        publisher.publish(Int64(data=number))
        assert wait_until(lambda number=number: heard[-1:] == [number])  # type: ignore[misc]
        node.destroy_publisher(publisher)
    assert heard == [0, 1, 2]
