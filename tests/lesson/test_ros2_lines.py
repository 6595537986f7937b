"""Lines that lessons about ROS 2 type word for word, with `zbot` in place of `ros2`."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Program, Start

TWIST = "{linear: {x: 2.0}, angular: {z: 1.8}}"
SPAWN = "{x: 2, y: 2, theta: 0.2, name: ''}"


@pytest.fixture
def turtle(start: Start) -> Program:
    program = start("zbot", "run", "turtlesim", "turtlesim_node")
    program.wait_for("Spawning turtle [turtle1]")
    return program


def test_run_demo_nodes_py_talker(start: Start) -> None:
    talker = start("zbot", "run", "demo_nodes_py", "talker")
    talker.wait_for('[talker]: Publishing: "Hello World: 0"')


def test_run_with_another_name(start: Start) -> None:
    turtle = start(
        "zbot", "run", "turtlesim", "turtlesim_node", "--ros-args", "-r", "__node:=my_turtle"
    )
    turtle.wait_for("[my_turtle]: Spawning turtle [turtle1]")
    assert zbot("node", "list").out == "/my_turtle\n"


@pytest.mark.usefixtures("turtle")
def test_topic_pub_once_to_two_and_topic_echo(start: Start) -> None:
    echo = start("zbot", "topic", "echo", "/turtle1/cmd_vel")
    done = zbot(
        *("topic", "pub", "--once", "-w", "2", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", TWIST)
    )
    assert done.code == 0
    assert done.out.endswith(
        "publishing #1: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, "
        "z=0.0), angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))\n\n"
    )
    echo.wait_for("  x: 2.0")
    echo.wait_for("  z: 1.8")
    echo.wait_for("---")


def test_topic_pub_fills_the_header(start: Start) -> None:
    values = '{header: "auto", pose: {position: {x: 1.0}}}'
    speaker = start("zbot", "topic", "pub", "/pose", "geometry_msgs/msg/PoseStamped", values)
    said = speaker.wait_for("publishing #1: ")
    assert re.search(r"Time\(sec=\d{10}, nanosec=\d+\)", said)
    assert "position=geometry_msgs.msg.Point(x=1.0, y=0.0, z=0.0)" in said


@pytest.mark.usefixtures("turtle")
def test_topic_hz(start: Start) -> None:
    start("zbot", "topic", "hz", "/turtle1/pose").wait_for_rate(62.5, 12)


def test_service_call(turtle: Program) -> None:
    done = zbot("service", "call", "/spawn", "turtlesim/srv/Spawn", SPAWN)
    assert (done.code, done.err) == (0, "")
    assert done.out == (
        "waiting for service to become available...\n"
        "requester: making request: "
        "turtlesim.srv.Spawn_Request(x=2.0, y=2.0, theta=0.2, name='')\n\n"
        "response:\nturtlesim.srv.Spawn_Response(name='turtle2')\n\n"
    )
    turtle.wait_for("Spawning turtle [turtle2]")


@pytest.mark.usefixtures("turtle")
def test_param_set_and_param_dump() -> None:
    done = zbot("param", "set", "/turtlesim", "background_r", "150")
    assert (done.code, done.out) == (0, "Set parameter successful\n")
    done = zbot("param", "dump", "/turtlesim")
    assert done.code == 0
    assert done.out.startswith("/turtlesim:\n  ros__parameters:\n")
    assert "    background_r: 150\n" in done.out


@pytest.mark.usefixtures("turtle")
def test_action_send_goal_with_feedback() -> None:
    done = zbot(
        *("action", "send_goal", "/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute"),
        *("{theta: 1.57}", "--feedback"),
    )
    assert (done.code, done.err) == (0, "")
    assert done.out.startswith(
        "Waiting for an action server to become available...\nSending goal:\n     theta: 1.57\n\n"
        "Goal accepted with ID: "
    )
    assert "Feedback:\n    remaining: " in done.out
    assert done.out.endswith("Goal finished with status: SUCCEEDED\n")


def test_interface_show() -> None:
    shown = zbot("interface", "show", "geometry_msgs/msg/Twist").out
    assert "Vector3  linear\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\n" in shown


def test_pkg_create(tmp_path: Path) -> None:
    words = ["--build-type", "ament_python", "--node-name", "my_node", "my_package"]
    assert zbot("pkg", "create", *words, cwd=tmp_path).code == 0
    assert zbot("run", "my_package", "my_node", cwd=tmp_path).out == "Hi from my_package.\n"
