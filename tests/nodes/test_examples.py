"""Tests of the programs in `examples/`, each in a process of its own."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.conftest import Program, Start

EXAMPLES = Path(__file__).parents[2] / "examples"
SAYS = {
    "publisher.py": "sent: message 1",
    "service_server.py": "the service is ready",
    "action_server.py": "the action is ready",
    "parameters.py": "hello",
    "lifecycle_node.py": "waiting for a transition",
    "own_message.py": "main: 11.2 V in 3 cells",
    "call_in_a_callback.py": "2 + 2 = 4",
    "await_services.py": "here is your tea of hot water",
    "live_parameters.py": "blink (2.0 Hz)",
    "keep_all.py": "keep-all saw [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]",
}


#: Examples with a test of their own, because they need another program.
TOGETHER = {
    "action_client.py",
    "maze.py",
    "plain_zenoh.py",
    "publisher_subscriber.launch.py",
    "service_client.py",
    "subscriber.py",
    "tf_broadcaster.py",
    "tf_listener.py",
}


def run(start: Start, name: str, *words: str) -> Program:
    return start("zbot", "run", str(EXAMPLES / name), *words)


def test_every_example_is_run_and_listed() -> None:
    names = {path.name for path in EXAMPLES.glob("*.py")}
    assert names == {*SAYS, *TOGETHER}
    listed = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    assert all(f"({name})" in listed for name in names)


@pytest.mark.parametrize("name", SAYS)
def test_an_example_prints_its_documented_output(name: str, start: Start) -> None:
    example = start("zbot", "run", str(EXAMPLES / name))
    example.wait_for(SAYS[name])
    example.stop()
    assert "Traceback" not in example.output


def test_the_subscriber_receives_what_the_publisher_sends(start: Start) -> None:
    subscriber = run(start, "subscriber.py")
    run(start, "publisher.py")
    subscriber.wait_for("received: message ")


def test_the_client_gets_the_response_of_the_server(start: Start) -> None:
    server = run(start, "service_server.py")
    client = run(start, "service_client.py")
    assert (client.wait(), client.output) == (0, "2 + 3 = 5")
    server.wait_for("2 + 3 = 5")


def test_the_action_client_prints_feedback_and_result(start: Start) -> None:
    run(start, "action_server.py")
    client = run(start, "action_client.py")
    assert client.wait() == 0
    assert client.lines[0] == "so far: [0, 1, 1]"
    assert client.lines[-1] == "result: [0, 1, 1, 2, 3, 5]"


def test_a_parameter_is_given_and_changed(start: Start) -> None:
    greeter = run(start, "parameters.py", "--ros-args", "-p", "text:=hi")
    greeter.wait_for("hi")
    assert start("zbot", "param", "set", "/greeter", "text", "good morning").wait() == 0
    greeter.wait_for("good morning")


def test_the_launch_file_uses_the_topic_that_is_given(start: Start) -> None:
    file = str(EXAMPLES / "publisher_subscriber.launch.py")
    launched = start("zbot", "launch", file, "topic:=news")
    launched.wait_for("received: Hello World: ")
    listed = start("zbot", "node", "list")
    assert listed.wait() == 0
    assert listed.lines == ["/speaker", "/subscriber"]
    assert start("zbot", "topic", "echo", "/news", "--once").wait() == 0
    assert launched.stop() == 0


def test_the_listener_sees_the_moon(start: Start) -> None:
    run(start, "tf_broadcaster.py")
    run(start, "tf_listener.py").wait_for("distance=2.00 m")
    start("zbot", "run", "tf2_echo", "planet", "moon").wait_for("Translation")


def test_the_managed_node_publishes_while_it_is_active(start: Start) -> None:
    node = run(start, "lifecycle_node.py")
    node.wait_for("waiting")
    for transition, text in (("configure", "configured"), ("activate", "messages are sent")):
        assert start("zbot", "lifecycle", "set", "/managed", transition).wait() == 0
        node.wait_for(text)
    assert start("zbot", "topic", "echo", "/chatter", "--once").wait() == 0


def test_the_plain_zenoh_program_reads_the_sensor(start: Start) -> None:
    start("zbot", "run", "sensor").wait_for("Temperature: ")
    reader = start(sys.executable, str(EXAMPLES / "plain_zenoh.py"))
    reader.wait_for("degrees")


def test_a_parameter_of_the_example_changes_its_rate(start: Start) -> None:
    blinker = start("zbot", "run", str(EXAMPLES / "live_parameters.py"))
    blinker.wait_for("blink (2.0 Hz)")
    assert start("zbot", "param", "set", "/blinker", "rate", "9.0").wait() == 0
    blinker.wait_for("blink (9.0 Hz)")
