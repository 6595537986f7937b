"""Tests of the log lines about probable mistakes: one line each, and no other line."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until

from std_msgs.msg import Float32, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext
    from zbot.log.record import Record


@pytest.fixture(autouse=True)
def check_delay(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let checks come soon, or after the seconds in the test's parameter."""
    delay_s = getattr(request, "param", 0.05)
    monkeypatch.setattr("zbot.node.diagnostics._CHECK_DELAY_S", delay_s)


# For tests in which something must happen before the check, also on a busy machine.
LATE_CHECK = pytest.mark.parametrize("check_delay", [1.5], indirect=True, ids=["late"])


@pytest.fixture
def lines(logged: list[Record]) -> Callable[[], list[str]]:
    return lambda: sorted(f"[{record.name}] {record.message}" for record in logged)


def after_the_check(node: zbot.Node, lines: Callable[[], list[str]]) -> list[str]:
    """Return the lines logged before the line about a later subscription's mistake."""
    publisher = node.create_publisher(String, "the_last_check", 10)
    node.create_subscription(String, "the_last_chec", print, 10)
    assert wait_until(lambda: any("the_last_chec," in line for line in lines()))
    publisher.destroy()
    return [line for line in lines() if "the_last_chec" not in line]


def test_a_misspelt_topic_is_one_line(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    talker.create_publisher(Float32, "temperature", 10)
    listener.create_subscription(Float32, "temprature", print, 10)
    listener.create_subscription(Float32, "temprature", print, 10)
    advice = (
        "[listener] nobody publishes /temprature, but /temperature (std_msgs/msg/Float32) has a "
        "publisher: is one of the names misspelt?"
    )
    assert after_the_check(listener, lines) == [advice]


def test_a_name_of_another_type_or_unlike_all_others_is_not_reported(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    talker.create_publisher(String, "temperature", 10)
    talker.create_publisher(Float32, "pressure", 10)
    listener.create_subscription(Float32, "temprature", print, 10)
    listener.create_subscription(Float32, "_presure", print, 10)
    assert after_the_check(listener, lines) == []


@LATE_CHECK
def test_a_publisher_that_comes_in_time_is_not_reported(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    talker.create_publisher(Float32, "temperature_1", 10)
    listener.create_subscription(Float32, "temperature_2", print, 10)
    talker.create_publisher(Float32, "temperature_2", 10)
    assert after_the_check(listener, lines) == []


@LATE_CHECK
def test_a_destroyed_subscription_is_not_reported(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    node = zbot.Node("robot", context=make_context())
    node.create_publisher(Float32, "temperature", 10)
    subscription = node.create_subscription(Float32, "temprature", print, 10)
    node.destroy_subscription(subscription)
    assert after_the_check(node, lines) == []


def test_two_types_on_one_topic_are_one_line_for_each_side(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    listener.create_subscription(String, "temperature", print, 10)
    talker.create_publisher(Float32, "temperature", 10)
    talker.create_publisher(Float32, "temperature", 10)
    at_listener = (
        "[listener] /temperature has two types: this node uses std_msgs/msg/String, but /talker "
        "publishes std_msgs/msg/Float32; they cannot receive each other's messages"
    )
    at_talker = (
        "[talker] /temperature has two types: this node uses std_msgs/msg/Float32, but /listener "
        "subscribes to std_msgs/msg/String; they cannot receive each other's messages"
    )
    assert wait_until(lambda: len(lines()) >= 2)
    assert after_the_check(listener, lines) == [at_listener, at_talker]


def test_two_nodes_of_one_name_are_one_line_for_each(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    first = zbot.Node("robot", context=make_context())
    second = zbot.Node("robot", context=make_context())
    advice = (
        "[robot] there is another node named /robot; give one of them another name: "
        "--ros-args -r __node:=robot_2"
    )
    assert wait_until(lambda: len(lines()) >= 2)
    assert after_the_check(second, lines) == [advice, advice]
    assert first.get_name() == second.get_name()


def test_a_name_that_was_freed_is_not_reported(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    first = zbot.Node("robot", context=make_context())
    first.context.shutdown()
    context = make_context()
    with zbot.Node("robot", context=context):
        pass
    second = zbot.Node("robot", context=context)
    assert after_the_check(second, lines) == []


def test_a_correct_program_causes_no_line(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    talker = zbot.Node("talker", context=make_context(), namespace="/a")
    listener = zbot.Node("talker", context=make_context(), namespace="/b")
    talker.create_publisher(String, "/chatter", 10)
    listener.create_subscription(String, "/chatter", print, 10)
    listener.create_publisher(String, "/chatter", 10)
    assert after_the_check(listener, lines) == []
