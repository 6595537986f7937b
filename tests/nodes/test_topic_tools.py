"""Tests of relay, throttle, drop, delay and mux."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.startup.program import ParameterError
from zbot_nodes.topics import delay, drop, throttle
from zbot_nodes.topics.delay import Delay
from zbot_nodes.topics.drop import Drop
from zbot_nodes.topics.mux import Mux
from zbot_nodes.topics.relay import Relay
from zbot_nodes.topics.throttle import Throttle

from geometry_msgs.msg import Point
from std_msgs.msg import Int32, String
from topic_tools_interfaces.srv import MuxAdd, MuxDelete, MuxList, MuxSelect

if TYPE_CHECKING:
    import zbot
    from tests.conftest import Start
    from tests.nodes.conftest import Bench

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def numbers(bench: Bench, topic: str) -> list[int]:
    found: list[int] = []
    bench.watcher.create_subscription(Int32, topic, lambda message: found.append(message.data), 10)
    return found


def connected(bench: Bench, topic: str, output: str, type_: Any = Int32, qos: Any = 10) -> Any:
    """Return a publisher that a tool has found. `output` is the topic of the tool."""
    publisher = bench.watcher.create_publisher(type_, topic, qos)
    graph = bench.watcher
    assert wait_until(lambda: publisher.get_subscription_count() > 0, 10)
    assert wait_until(lambda: graph.count_publishers(output) > 0, 10)
    return publisher


def test_a_relay_takes_over_type_and_profile(bench: Bench) -> None:
    bench.run(Relay, {"input_topic": "a", "output_topic": "b"})
    publisher = connected(bench, "/a", "/b", String, KEPT)
    publisher.publish(String(data="floor 2"))
    late = bench.watch(String, "/b", KEPT)
    assert wait_until(lambda: [message.data for message in late] == ["floor 2"])
    (info,) = bench.watcher.get_publishers_info_by_topic("/b")
    assert info.topic_type == "std_msgs/msg/String"
    assert info.qos_profile.durability is DurabilityPolicy.TRANSIENT_LOCAL


def test_a_relay_follows_another_type(bench: Bench) -> None:
    bench.run(Relay, {"input_topic": "a"})
    first = connected(bench, "/a", "/a_relay")
    bench.watcher.destroy_publisher(first)
    heard = bench.watch(Point, "/a_relay")
    second = bench.watcher.create_publisher(Point, "/a", 10)

    def arrives() -> bool:
        second.publish(Point(x=1.0))
        return bool(heard)

    assert wait_until(arrives, 10)


def test_a_relay_finds_its_input_while_the_time_of_a_simulation_stands_still(bench: Bench) -> None:
    bench.run(Relay, {"input_topic": "a", "use_sim_time": True})
    connected(bench, "/a", "/a_relay")


def test_a_lazy_relay_subscribes_only_for_somebody(bench: Bench) -> None:
    bench.run(Relay, {"input_topic": "a", "lazy": True})
    publisher = bench.watcher.create_publisher(Int32, "/a", 10)
    assert wait_until(lambda: bench.watcher.count_publishers("/a_relay") > 0, 10)
    assert publisher.get_subscription_count() == 0
    subscription = bench.watcher.create_subscription(Int32, "/a_relay", lambda _: None, 10)
    assert wait_until(lambda: publisher.get_subscription_count() == 1, 10)
    bench.watcher.destroy_subscription(subscription)
    assert wait_until(lambda: publisher.get_subscription_count() == 0, 10)


def test_a_drop_leaves_out_the_first_of_each_group(bench: Bench) -> None:
    heard = numbers(bench, "/a_drop")
    bench.run(Drop, {"input_topic": "a", "X": 2, "Y": 3})
    publisher = connected(bench, "/a", "/a_drop")
    for number in range(9):
        publisher.publish(Int32(data=number))
    assert wait_until(lambda: heard == [2, 5, 8])


def send_five_after_the_period(node: Throttle, publisher: zbot.Publisher[Int32]) -> None:
    node.last_ns -= 200 * 10**9  # the period of 100 s is over
    for number in range(5):
        publisher.publish(Int32(data=number))


def test_a_throttle_limits_the_rate(bench: Bench) -> None:
    heard = numbers(bench, "/a_throttle")
    settings = {"input_topic": "a", "throttle_type": "messages", "msgs_per_sec": 0.01}
    node = bench.run(Throttle, settings)
    assert isinstance(node, Throttle)
    publisher = connected(bench, "/a", "/a_throttle")
    send_five_after_the_period(node, publisher)
    assert wait_until(lambda: len(heard) == 1)
    send_five_after_the_period(node, publisher)
    assert wait_until(lambda: len(heard) == 2)
    assert not wait_until(lambda: len(heard) > 2, 0.3)
    assert heard[0] == 0


def test_a_throttle_limits_the_bytes(bench: Bench) -> None:
    heard = bench.watch(String, "/a_throttle")
    settings = {"input_topic": "a", "throttle_type": "bytes", "bytes_per_sec": 150, "window": 60.0}
    bench.run(Throttle, settings)
    publisher = connected(bench, "/a", "/a_throttle", String)
    for _ in range(5):
        publisher.publish(String(data="x" * 100))
    assert wait_until(lambda: len(heard) == 2)
    publisher.publish(String(data="x"))
    assert not wait_until(lambda: len(heard) > 2, 0.3)


def test_a_delay_keeps_the_order(bench: Bench) -> None:
    heard: list[tuple[int, int]] = []
    clock = bench.watcher.get_clock()
    bench.watcher.create_subscription(
        Int32, "/late", lambda message: heard.append((message.data, clock.now().nanoseconds)), 10
    )
    bench.run(Delay, {"input_topic": "a", "output_topic": "late", "delay": 0.3})
    publisher = connected(bench, "/a", "/late")
    sent_ns = clock.now().nanoseconds
    for number in range(3):
        publisher.publish(Int32(data=number))
    assert wait_until(lambda: [number for number, _ in heard] == [0, 1, 2])
    assert all(at - sent_ns >= 0.3e9 for _, at in heard)


def test_a_mux_has_services_that_choose(bench: Bench) -> None:
    heard = numbers(bench, "/out")
    bench.run(Mux, {"input_topics": ["a", "b"], "output_topic": "out"})
    first = connected(bench, "/a", "/out")
    second = bench.watcher.create_publisher(Int32, "/b", 10)
    first.publish(Int32(data=1))
    assert wait_until(lambda: heard == [1])
    answer = bench.call(MuxSelect, "/mux/select", MuxSelect.Request(topic="/b"))
    assert (answer.prev_topic, answer.success) == ("a", True)
    assert wait_until(lambda: second.get_subscription_count() == 1, 10)
    second.publish(Int32(data=2))
    assert wait_until(lambda: heard == [1, 2])
    assert not bench.call(MuxSelect, "/mux/select", MuxSelect.Request(topic="z")).success
    assert not bench.call(MuxAdd, "/mux/add", MuxAdd.Request(topic="/a")).success
    assert bench.call(MuxAdd, "/mux/add", MuxAdd.Request(topic="c")).success
    assert not bench.call(MuxDelete, "/mux/delete", MuxDelete.Request(topic="b")).success
    assert bench.call(MuxDelete, "/mux/delete", MuxDelete.Request(topic="a")).success
    assert list(bench.call(MuxList, "/mux/list", MuxList.Request()).topics) == ["b", "c"]
    assert bench.call(MuxSelect, "/mux/select", MuxSelect.Request(topic="__none")).success
    assert wait_until(lambda: second.get_subscription_count() == 0, 10)


@pytest.mark.parametrize(
    ("kind", "settings", "reason"),
    [
        (Relay, {}, "the parameter input_topic is missing: relay INPUT"),
        (Drop, {"input_topic": "a", "X": 3, "Y": 2}, "0 <= X <= Y"),
        (Delay, {"input_topic": "a", "delay": -1.0}, "delay must be a finite number, not below 0"),
        (Delay, {"input_topic": "a", "delay": math.inf}, "delay must be a finite number"),
        (Mux, {}, "input_topics is missing"),
        (Throttle, {"input_topic": "a", "throttle_type": "x"}, "messages or bytes, not 'x'"),
        (
            Throttle,
            {"input_topic": "a", "throttle_type": "messages"},
            "msgs_per_sec must be a finite number above 0",
        ),
    ],
)
def test_settings_that_cannot_be_used_are_refused(
    bench: Bench, kind: Any, settings: dict[str, Any], reason: str
) -> None:
    with pytest.raises(ParameterError, match=reason):
        bench.run(kind, settings)


def settings_of(parameters: list[zbot.Parameter[Any]]) -> dict[str, Any]:
    return {parameter.name: parameter.value for parameter in parameters}


def test_command_lines_set_the_parameters() -> None:
    assert settings_of(throttle.read_arguments(["messages", "a", "2", "b"])) == {
        "throttle_type": "messages",
        "input_topic": "a",
        "msgs_per_sec": 2.0,
        "output_topic": "b",
    }
    assert settings_of(throttle.read_arguments(["bytes", "a", "1024", "0.5"])) == {
        "throttle_type": "bytes",
        "input_topic": "a",
        "bytes_per_sec": 1024,
        "window": 0.5,
    }
    assert settings_of(drop.read_arguments(["a", "1", "2"])) == {"input_topic": "a", "X": 1, "Y": 2}
    assert settings_of(delay.read_arguments(["a", "0.5"])) == {"input_topic": "a", "delay": 0.5}
    with pytest.raises(ParameterError, match="the delay must be a number, not 'x'"):
        delay.read_arguments(["a", "x"])
    with pytest.raises(ParameterError, match="X must be a number, not 'inf'"):
        drop.read_arguments(["a", "inf", "2"])


def test_the_programs_pass_messages_on(start: Start) -> None:
    start("zbot", "run", "topic_tools", "relay", "chatter", "shout")
    start("zbot", "run", "topic_tools", "throttle", "messages", "shout", "5")
    start("zbot", "run", "topic_tools", "drop", "shout_throttle", "0", "1")
    start("zbot", "run", "topic_tools", "delay", "shout_throttle_drop", "0.1", "slow")
    start("zbot", "run", "topic_tools", "mux", "end", "slow", "other")
    start("zbot", "run", "talker")
    listener = start("zbot", "run", "listener", "--ros-args", "-r", "chatter:=end")
    listener.wait_for("Hello World", 20)
    wrong = start("zbot", "run", "topic_tools", "drop", "a", "x", "2")
    wrong.wait_for("error: X must be a number, not 'x'")
    assert wrong.wait() == 1
