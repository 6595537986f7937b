"""Tests of the selection of topics, and of the memory of a recorder in snapshot mode."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from zbot.bag import Reader, Writer
from zbot.bag.description import contributions, description, topic_names
from zbot.bag.message import BagMessage
from zbot.bag.selection import Selection
from zbot.bag.write_queue import SnapshotBuffer

from action_msgs.msg import GoalStatusArray
from example_interfaces.action import Fibonacci
from std_msgs.msg import String

if TYPE_CHECKING:
    from pathlib import Path

TOPICS = {
    "/chatter": "std_msgs/msg/String",
    "/lamp/_service_event": "std_srvs/srv/SetBool_Event",
    "/fib/_action/feedback": "example_interfaces/action/Fibonacci_FeedbackMessage",
    "/fib/_action/send_goal/_service_event": ("example_interfaces/action/Fibonacci_SendGoal_Event"),
}


@pytest.mark.parametrize(
    ("rules", "expected"),
    [
        ({"all_topics": True}, ["/chatter"]),
        ({"all_services": True}, ["/lamp/_service_event"]),
        ({"all_actions": True}, ["/fib/_action/feedback", "/fib/_action/send_goal/_service_event"]),
        ({"actions": {"/fib"}}, ["/fib/_action/feedback", "/fib/_action/send_goal/_service_event"]),
        ({"actions": {"/other"}}, []),
        ({"all_actions": True, "exclude_actions": {"/fib"}}, []),
        ({"regex": "fib|lamp"}, [*TOPICS][1:]),
        ({"regex": ".", "exclude_regex": "fib"}, [*TOPICS][:2]),
        ({"topic_types": {"std_msgs/msg/String"}}, ["/chatter"]),
    ],
)
def test_rules_select_topics_services_and_actions(
    rules: dict[str, Any], expected: list[str]
) -> None:
    selection = Selection(**rules)
    assert [topic for topic, kind in TOPICS.items() if selection.takes(topic, kind)] == expected


def test_an_action_has_five_topics() -> None:
    assert len(Selection(actions=frozenset({"/fib"})).names) == 5


def test_info_describes_actions_as_ros2(path: Path) -> None:
    event = Fibonacci.Impl.SendGoalService.Event()
    with Writer(path) as bag:
        bag.write("/chatter", String(data="a"), 1)
        bag.write("/fib/_action/feedback", Fibonacci.Impl.FeedbackMessage(), 2)
        bag.write("/fib/_action/feedback", Fibonacci.Impl.FeedbackMessage(), 3)
        bag.write("/fib/_action/status", GoalStatusArray(), 4)
        bag.write("/fib/_action/send_goal/_service_event", event, 5)
    with Reader(path) as read:
        lines = description(read.metadata).splitlines()
        sizes, calls = contributions(read)
        verbose = description(read.metadata, sizes=sizes, calls=calls).splitlines()
        assert topic_names(read.metadata) == ["/chatter"]
    assert lines[8:10] == [
        "Messages:          1",
        (
            "Topic information: Topic: /chatter | Type: std_msgs/msg/String | Count: 1 | "
            "Serialization Format: cdr"
        ),
    ]
    assert lines[12:] == [
        "Actions:           1",
        "Action information: ",
        (
            "  Action: /fib | Type: example_interfaces/action/Fibonacci | Topics: 2 | Service: 3 | "
            "Serialization Format: cdr"
        ),
        "    Topic: feedback | Count: 2",
        "    Topic: status | Count: 1",
        "    Service: send_goal | Event Count: 1",
        "    Service: cancel_goal | Event Count: 0",
        "    Service: get_result | Event Count: 0",
    ]
    assert verbose[17] == "    Service: send_goal | Request Count: 1 | Response Count: 0"


def message(number: int, size: int = 10) -> BagMessage:
    return BagMessage("/a", bytes(size), number * 10**9, number)


def test_a_snapshot_keeps_the_newest_bytes() -> None:
    buffer = SnapshotBuffer(max_bytes=35, max_duration_s=0)
    for number in range(10):
        buffer.add(message(number))
    assert [buffered.publish_ns for buffered in buffer.take()] == [7, 8, 9]
    assert buffer.take() == []
    buffer.add(message(1, 1000))  # a message that is larger than the limit is kept alone
    assert len(buffer.take()) == 1


def test_a_snapshot_keeps_the_newest_seconds() -> None:
    buffer = SnapshotBuffer(max_bytes=0, max_duration_s=2)
    for number in range(10):
        buffer.add(message(number))
    assert [buffered.publish_ns for buffered in buffer.take()] == [7, 8, 9]
