"""The `ros2` lines of both lessons about run, node, topic and interface, typed as `zbot`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from tests.conftest import Program, Start

TWIST = "{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}"
TWIST_TEXT = """\
linear:
  x: 2.0
  y: 0.0
  z: 0.0
angular:
  x: 0.0
  y: 0.0
  z: 1.8
---
"""
LOG = r"\[{}\] \[\d+\.\d{{9}}\] \[{}\]: {}"


def out(*words: str) -> str:
    done = zbot(*words)
    assert done.code == 0, done.err
    return done.out


@pytest.fixture
def sensor(start: Start) -> Program:
    program = start("zbot", "run", "sensor")
    program.wait_for("Temperature:")
    return program


def test_version() -> None:
    assert re.match(r"zbot \d+\.\d+\.\d+ \(eclipse-zenoh \d", out("--version"))


def test_the_sensor_and_the_monitor_say_what_the_lesson_says(start: Start, sensor: Program) -> None:
    assert re.fullmatch(
        LOG.format("INFO", "temperature_sensor", "Temperature sensor started"), sensor.lines[0]
    )
    reading = sensor.wait_for("Temperature:")
    assert re.fullmatch(
        LOG.format("INFO", "temperature_sensor", r"Temperature: 2\d\.\d\d°C"), reading
    )
    monitor = start("zbot", "run", "zbot_nodes", "monitor")
    monitor.wait_for("[temperature_monitor]: Temperature monitor started")
    judged = monitor.wait_for(" temperature: ")
    kind, degrees = re.search(r"(High|Low|Normal) temperature: (\d\d\.\d\d)°C", judged).groups()  # type: ignore[union-attr]
    wanted = "High" if float(degrees) > 28 else "Low" if float(degrees) < 22 else "Normal"
    assert kind == wanted
    assert f"[{'WARN' if kind == 'High' else 'INFO'}]" in judged
    assert monitor.stop() == sensor.stop()
    assert "Traceback" not in monitor.output + sensor.output


@pytest.mark.usefixtures("sensor")
def test_nodes_are_listed_and_described() -> None:
    assert out("node", "list") == "/temperature_sensor\n"
    assert out("node", "info", "/temperature_sensor") == (
        "/temperature_sensor\n"
        "  Subscribers:\n\n"
        "  Publishers:\n"
        "    /parameter_events: rcl_interfaces/msg/ParameterEvent\n"
        "    /rosout: rcl_interfaces/msg/Log\n"
        "    /temperature: std_msgs/msg/Float32\n"
        "  Service Servers:\n"
        "    /temperature_sensor/describe_parameters: rcl_interfaces/srv/DescribeParameters\n"
        "    /temperature_sensor/get_parameter_types: rcl_interfaces/srv/GetParameterTypes\n"
        "    /temperature_sensor/get_parameters: rcl_interfaces/srv/GetParameters\n"
        "    /temperature_sensor/list_parameters: rcl_interfaces/srv/ListParameters\n"
        "    /temperature_sensor/set_parameters: rcl_interfaces/srv/SetParameters\n"
        "    /temperature_sensor/set_parameters_atomically: "
        "rcl_interfaces/srv/SetParametersAtomically\n"
        "  Service Clients:\n\n"
        "  Action Servers:\n\n"
        "  Action Clients:\n\n"
    )


@pytest.mark.usefixtures("sensor")
def test_topics_are_listed_and_described() -> None:
    assert out("topic", "list") == "/parameter_events\n/rosout\n/temperature\n"
    assert out("topic", "list", "-t") == (
        "/parameter_events [rcl_interfaces/msg/ParameterEvent]\n"
        "/rosout [rcl_interfaces/msg/Log]\n"
        "/temperature [std_msgs/msg/Float32]\n"
    )
    assert out("topic", "info", "/temperature") == (
        "Type: std_msgs/msg/Float32\nPublisher count: 1\nSubscription count: 0\n"
    )


@pytest.mark.usefixtures("sensor")
def test_a_topic_is_echoed() -> None:
    assert re.fullmatch(r"data: 2\d\.\d+\n---\n", out("topic", "echo", "--once", "temperature"))


@pytest.mark.usefixtures("sensor")
def test_a_rate_is_measured(start: Start) -> None:
    meter = start("zbot", "topic", "hz", "/temperature")
    meter.wait_for_rate(1, within_hz=0.2)
    assert re.fullmatch(
        r"\tmin: [01]\.\d{3}s max: [01]\.\d{3}s std dev: 0\.\d{5}s window: \d+",
        meter.wait_for("window"),
    )
    assert meter.stop() == 130
    assert "Traceback" not in meter.output


def test_the_turtle_is_told_to_move_once(start: Start) -> None:
    listener = start("zbot", "topic", "echo", "/turtle1/cmd_vel")
    listener.wait_for("waiting for /turtle1/cmd_vel")
    published = out("topic", "pub", "--once", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST)
    assert published.endswith(
        "publisher: beginning loop\n"
        "publishing #1: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, "
        "z=0.0), angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))\n\n"
    )
    listener.wait_for("---")
    assert listener.stop() == 130
    assert "\n".join(listener.lines[-9:]) + "\n" == TWIST_TEXT


def test_the_turtle_is_told_to_move_at_a_rate(start: Start) -> None:
    speaker = start(
        "zbot", "topic", "pub", "--rate", "1", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST
    )
    speaker.wait_for("publishing #2")
    assert out("topic", "echo", "/turtle1/cmd_vel", "--once") == TWIST_TEXT
    assert out("topic", "type", "/turtle1/cmd_vel") == "geometry_msgs/msg/Twist\n"
    assert out("topic", "find", "geometry_msgs/msg/Twist") == "/turtle1/cmd_vel\n"
    assert speaker.stop() == 130


def test_strings_are_published(start: Start) -> None:
    speaker = start("zbot", "topic", "pub", "/chatter", "std_msgs/msg/String", "data: 'Hello'")
    speaker.wait_for("publishing #1: std_msgs.msg.String(data='Hello')")
    assert out("topic", "echo", "/chatter", "--once") == "data: Hello\n---\n"


def test_interfaces_are_shown() -> None:
    twist = out("interface", "show", "geometry_msgs/msg/Twist").splitlines()
    assert [line for line in twist if line and not line.startswith("#")] == [
        "Vector3  linear",
        "\tfloat64 x",
        "\tfloat64 y",
        "\tfloat64 z",
        "Vector3  angular",
        "\tfloat64 x",
        "\tfloat64 y",
        "\tfloat64 z",
    ]
    assert "string data" in out("interface", "show", "std_msgs/msg/String").splitlines()


def test_the_assignment_publishes_an_id_and_a_number(start: Start) -> None:
    speaker = start("zbot", "run", "student_publisher", "S1234567")
    speaker.wait_for("Student ID: S1234567, random number: ")
    listener = start("zbot", "run", "student_subscriber")
    listener.wait_for("Received student ID: S1234567")
    listener.wait_for("Received random number: ")
    assert out("topic", "echo", "/student_id", "--once") == "data: S1234567\n---\n"
    assert out("node", "list") == "/student_publisher\n/student_subscriber\n"
    assert out("topic", "info", "/random_number") == (
        "Type: std_msgs/msg/Int32\nPublisher count: 1\nSubscription count: 1\n"
    )


def test_talker_and_listener(start: Start) -> None:
    speaker = start("zbot", "run", "demo_nodes_py", "talker")
    speaker.wait_for('[talker]: Publishing: "Hello World: 0"')
    listener = start("zbot", "run", "demo_nodes_py", "listener")
    listener.wait_for("[listener]: I heard: [Hello World: ")


@pytest.mark.usefixtures("sensor")
def test_parameters_are_listed_and_read() -> None:
    assert out("param", "list") == (
        "/temperature_sensor:\n  start_type_description_service\n  use_sim_time\n"
    )
    value = out("param", "get", "/temperature_sensor", "use_sim_time")
    assert value == "Boolean value is: False\n"
