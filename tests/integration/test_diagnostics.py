"""Tests of the log lines about probable mistakes: one line each, and no other line."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer
from zbot.lifecycle import LifecycleNode

from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import Float32, String
from std_srvs.srv import Trigger

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.conftest import MakeContext, Spin
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


def test_a_misspelt_topic_whose_publisher_comes_later_is_one_line(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    talker.create_publisher(Float32, "pressure", 10)
    listener.create_subscription(Float32, "temprature", print, 10)
    assert after_the_check(listener, lines) == []
    talker.create_publisher(Float32, "temperature", 10)
    advice = "nobody publishes /temprature, but /temperature (std_msgs/msg/Float32) has a publisher"
    assert wait_until(lambda: any(advice in line for line in lines()))


@LATE_CHECK
def test_a_remapping_with_a_misspelt_name_is_one_line(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    rules = ("chater:=a", "pressure:=b", "speed:=c")
    words = [word for rule in rules for word in ("-r", rule)]
    node = zbot.Node("talker", context=make_context(), cli_args=["--ros-args", *words])
    node.create_publisher(String, "chatter", 10)
    node.create_publisher(String, "pressure", 10)
    text = "[talker] the remapping of /chater has no effect, but this node uses /chatter: "
    assert after_the_check(node, lines) == [text + "is one of the names misspelt?"]


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


def test_a_misspelt_service_is_one_line(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    talker.create_service(AddTwoInts, "add_two_ints", print)
    talker.create_service(Trigger, "local_costmap", print)
    listener.create_client(Trigger, "global_costmap")
    listener.create_client(AddTwoInts, "ad_two_ints")
    advice = (
        "[listener] nobody offers /ad_two_ints, but /add_two_ints "
        "(example_interfaces/srv/AddTwoInts) has a server: is one of the names misspelt?"
    )
    assert after_the_check(listener, lines) == [advice]


def test_a_misspelt_action_is_one_line(
    talker: zbot.Node, listener: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    ActionServer(talker, Fibonacci, "fibonacci", print)
    ActionClient(listener, Fibonacci, "fibonaci")
    advice = (
        "[listener] nobody offers /fibonaci, but /fibonacci (example_interfaces/action/Fibonacci) "
        "has a server: is one of the names misspelt?"
    )
    assert after_the_check(listener, lines) == [advice]


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


GIVEN = ["--ros-args", "-p", "nam:=Ana", "-p", "other:speed:=2"]


def test_a_parameter_that_nobody_declares_is_one_line(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    node = zbot.Node("greeter", context=make_context(), cli_args=GIVEN)
    node.declare_parameter("name", "Ben")
    (line,) = after_the_check(node, lines)
    assert line.startswith("[greeter] this node does not declare the parameter nam of the ")
    assert line.endswith("; did you mean 'name'?")


FILE = """
/**:
  ros__parameters:
    sped: 2.0
    width: 3.0
    heigth: 4.0
    height: 5.0
"""


def test_a_misspelt_parameter_in_a_file_is_one_line(
    make_context: MakeContext, lines: Callable[[], list[str]], tmp_path: Path
) -> None:
    (tmp_path / "robot.yaml").write_text(FILE)
    given = ["--ros-args", "--params-file", str(tmp_path / "robot.yaml")]
    node = zbot.Node("robot", context=make_context(), cli_args=given)
    node.declare_parameters("", [("speed", 1.0), ("height", 1.0), ("mass", 1.0)])
    advice = (
        "this node does not declare the parameter sped that it was given; did you mean 'speed'?"
    )
    assert after_the_check(node, lines) == [f"[robot] {advice}"]


def test_a_node_without_parameters_says_so_when_it_is_spun(
    make_context: MakeContext, lines: Callable[[], list[str]], spin: Spin
) -> None:
    node = zbot.Node("greeter", context=make_context(), cli_args=GIVEN)
    assert after_the_check(node, lines) == []  # its __init__ may still run
    spin(node)
    assert wait_until(lambda: any("it declares none" in line for line in lines()))
    (line,) = (line for line in lines() if "the_last_chec" not in line)
    assert line.endswith("the parameter nam of the command line; it declares none")


@pytest.mark.parametrize(
    "options",
    [
        {"allow_undeclared_parameters": True},
        {"automatically_declare_parameters_from_overrides": True},
    ],
)
def test_a_node_that_takes_any_parameter_gets_no_line(
    make_context: MakeContext, lines: Callable[[], list[str]], options: dict[str, bool]
) -> None:
    node = zbot.Node("greeter", context=make_context(), cli_args=GIVEN, **options)  # type: ignore[arg-type]
    assert after_the_check(node, lines) == []


@LATE_CHECK
def test_another_node_of_the_program_may_declare_the_parameter(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    context = make_context()
    node = zbot.Node("greeter", context=context, cli_args=GIVEN)
    zbot.Node("second", context=context).declare_parameter("nam", "Ben")
    assert after_the_check(node, lines) == []


def test_a_managed_node_may_declare_parameters_later(
    make_context: MakeContext, lines: Callable[[], list[str]]
) -> None:
    node = LifecycleNode("greeter", context=make_context(), cli_args=GIVEN)
    assert after_the_check(node, lines) == []


@pytest.fixture
def program(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let each entity come from a line of a program, and let three be many."""
    monkeypatch.setattr("zbot.node.diagnostics.calling_line", lambda: "robot.py:9")
    monkeypatch.setattr("zbot.node.diagnostics.MOST_EQUAL", 3)
    monkeypatch.setattr("zbot.node.entities.MOST_EQUAL", 3)


@pytest.mark.usefixtures("program")
def test_entities_that_a_callback_makes_again_and_again_are_one_line_of_each_kind(
    talker: zbot.Node, lines: Callable[[], list[str]]
) -> None:
    for _ in range(4):
        talker.create_publisher(String, "t", 10)
        talker.create_subscription(String, "t", print, 10)
        talker.create_client(Trigger, "s")
        talker.create_timer(100, print)
        talker.destroy_publisher(talker.create_publisher(String, "kept", 10))
    what = ("3 clients of /s", "3 publishers of /t", "3 subscriptions to /t", "3 timers")
    assert lines() == [
        f"[talker] robot.py:9: this node now has {many}: create one in __init__, and keep it"
        for many in what
    ]
