"""Tests of `zbot serial` with pseudo-terminals in place of boards."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until

from sensor_msgs.msg import Imu
from std_msgs.msg import Bool, Float32, Int32, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import MakeContext, Program, Spin, Start
    from tests.pseudo_board import PseudoBoard

    PlugIn = Callable[[str], PseudoBoard]


class Listener:
    """Node that keeps the messages of topics."""

    def __init__(self, make_context: MakeContext, spin: Spin) -> None:
        self.node = zbot.Node("computer", context=make_context())
        self.heard: dict[str, list[Any]] = {}
        spin(self.node)

    def hear(self, topic: str, message_type: type[Any]) -> list[Any]:
        heard = self.heard[topic] = []
        self.node.create_subscription(message_type, topic, heard.append, 20000)
        return heard


@pytest.fixture
def listener(make_context: MakeContext, spin: Spin) -> Listener:
    return Listener(make_context, spin)


def started(start: Start, board: PseudoBoard, *words: str) -> Program:
    program = start("zbot", "serial", board.port, *words)
    program.wait_for("is open at")
    return program


def test_lines_of_a_board_are_topics(plug_in: PlugIn, start: Start, listener: Listener) -> None:
    heard = {
        topic: listener.hear(topic, kind)
        for topic, kind in (
            ("/temperature", Float32),
            ("/count", Int32),
            ("/button", Bool),
            ("/state", String),
            ("/imu", Imu),
            ("/room/humidity", Int32),
        )
    }
    board = plug_in("ttyACM0")
    program = started(start, board)
    for _ in range(2):  # the first message of a topic may come before the subscription
        board.print("temperature: 23.5", "count 7", "button: true", "state: open")
        board.print("/imu sensor_msgs/msg/Imu {angular_velocity: {z: 0.5}}")
        board.print('{"room": {"humidity": 41}}')
        assert wait_until(lambda: all(map(listener.node.count_publishers, heard)))
    assert wait_until(lambda: all(heard.values()))
    assert heard["/temperature"][-1].data == 23.5
    assert heard["/imu"][-1].angular_velocity.z == 0.5
    assert heard["/imu"][-1].header.stamp.sec > 0
    assert heard["/room/humidity"][-1].data == 41
    board.print("This was all")
    program.wait_for("This was all")
    names = listener.node.get_node_names()
    assert "board_ttyACM0" in names
    program.stop()
    assert "13 lines received, 12 published, 1 shown as text, 0 lost" in program.output


def test_messages_go_to_the_board(plug_in: PlugIn, start: Start, listener: Listener) -> None:
    board = plug_in("ttyACM0")
    started(start, board, "--to", "/led:std_msgs/msg/Bool", "/speed:Float32=motor")
    led = listener.node.create_publisher(Bool, "/led", 10)
    speed = listener.node.create_publisher(Float32, "/speed", 10)
    assert wait_until(lambda: led.get_subscription_count() > 0)
    assert wait_until(lambda: speed.get_subscription_count() > 0)
    led.publish(Bool(data=True))
    assert board.read_line() == "led: 1"
    speed.publish(Float32(data=0.5))
    assert board.read_line() == "motor: 0.5"


def test_a_board_that_was_unplugged_comes_back(
    plug_in: PlugIn, start: Start, listener: Listener
) -> None:
    heard = listener.hear("/count", Int32)
    board = plug_in("ttyACM0")
    program = started(start, board)
    board.print("count: 1")
    program.wait_for("new topic /count")
    board.unplug()
    program.wait_for("was unplugged: waiting until it is back")
    board.plug_in()
    program.wait_for("is open at")
    board.print("count: 2")
    assert wait_until(lambda: 2 in [message.data for message in heard])


def test_garbage_is_counted_and_the_baud_rate_is_named(plug_in: PlugIn, start: Start) -> None:
    board = plug_in("ttyACM0")
    program = started(start, board)
    board.write(b"\xfe\x80\x00\x13\n" * 3 + b"count: 1\n")
    told = program.wait_for("it is not text")
    assert "Serial.begin(...) must be 115200" in told
    board.print("This was all")
    program.wait_for("This was all")
    program.stop()
    assert (
        "5 lines received, 1 published, 1 shown as text, 3 lost (it is not text)" in program.output
    )


def test_a_value_of_another_type_is_counted(plug_in: PlugIn, start: Start) -> None:
    board = plug_in("ttyACM0")
    program = started(start, board)
    board.print("temperature: 23", "temperature: 23.5")
    told = program.wait_for("lost")
    assert "the value is no std_msgs/msg/Int32, on temperature" in told
    assert "--type temperature:Float32" in told


def test_texts_of_a_board_are_log_lines(plug_in: PlugIn, start: Start) -> None:
    board = plug_in("ttyACM0")
    program = started(start, board)
    board.print("Sensor ready")
    program.wait_for("[board_ttyACM0]: Sensor ready")


def test_two_boards_have_two_nodes_and_namespaces(
    plug_in: PlugIn, start: Start, listener: Listener
) -> None:
    left, right = plug_in("ttyACM0"), plug_in("ttyACM1")
    started(start, left, "--namespace", "left")
    started(start, right, "--namespace", "/right", "--name", "arduino")
    left.print("count: 1")
    right.print("count: 2")
    assert wait_until(lambda: listener.node.count_publishers("/left/count") == 1)
    assert wait_until(lambda: listener.node.count_publishers("/right/count") == 1)
    found = listener.node.get_node_names_and_namespaces()
    assert {("board_ttyACM0", "/left"), ("arduino", "/right")} <= set(found)


def test_a_port_that_another_program_uses_is_named(plug_in: PlugIn, start: Start) -> None:
    board = plug_in("ttyACM0")
    started(start, board)
    second = start("zbot", "serial", board.port)
    assert "another program uses" in second.wait_for("uses")
    assert second.wait() == 1


def test_ten_thousand_lines_in_a_second_arrive_or_are_counted(
    plug_in: PlugIn, start: Start, listener: Listener
) -> None:
    count = 10_000
    heard = listener.hear("/count", Int32)
    board = plug_in("ttyACM0")
    program = started(start, board)
    board.print("count: -1")
    assert wait_until(lambda: listener.node.count_publishers("/count") == 1)
    for first in range(0, count, 100):
        board.print(*(f"count: {number}" for number in range(first, first + 100)))
    assert wait_until(lambda: bool(heard) and heard[-1].data == count - 1, 30)
    program.stop()
    assert f"{count + 1} lines received, {count + 1} published, 0 lost" in program.output


def test_a_board_that_is_silent_gets_a_hint(plug_in: PlugIn, start: Start) -> None:
    board = plug_in("ttyACM0")
    program = started(start, board)
    assert "--sketch arduino" in program.wait_for("no line has come for 5 s")
