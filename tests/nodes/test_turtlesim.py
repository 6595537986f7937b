"""Tests of turtlesim in real processes, with the commands of the lesson."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.conftest import Program, Start


@pytest.fixture
def turtlesim(start: Start) -> Program:
    program = start("zbot", "run", "turtlesim", "turtlesim_node")
    program.wait_for("Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]")
    return program


def output(start: Start, *words: str) -> str:
    program = start("zbot", *words)
    assert program.wait() == 0, program.output
    return program.output


def pose(start: Start) -> dict[str, float]:
    text = output(start, "topic", "echo", "--once", "/turtle1/pose")
    return {name: float(value) for name, value in re.findall(r"^(\w+): (\S+)$", text, re.MULTILINE)}


def test_the_node_has_the_endpoints_of_the_tutorial(turtlesim: Program, start: Start) -> None:
    text = output(start, "node", "info", "/turtlesim")
    for name in (
        "/turtle1/cmd_vel: geometry_msgs/msg/Twist",
        "/turtle1/color_sensor: turtlesim/msg/Color",
        "/turtle1/pose: turtlesim/msg/Pose",
        "/clear: std_srvs/srv/Empty",
        "/kill: turtlesim/srv/Kill",
        "/reset: std_srvs/srv/Empty",
        "/spawn: turtlesim/srv/Spawn",
        "/turtle1/set_pen: turtlesim/srv/SetPen",
        "/turtle1/teleport_absolute: turtlesim/srv/TeleportAbsolute",
        "/turtle1/teleport_relative: turtlesim/srv/TeleportRelative",
        "/turtlesim/set_parameters: rcl_interfaces/srv/SetParameters",
        "/turtle1/rotate_absolute: turtlesim/action/RotateAbsolute",
    ):
        assert f"    {name}\n" in text
    assert turtlesim.stop() == -2


def test_a_command_draws_an_arc(turtlesim: Program, start: Start) -> None:
    assert turtlesim.process.poll() is None
    command = "{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {x: 0.0, y: 0.0, z: 1.8}}"
    output(start, "topic", "pub", "--once", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", command)
    output(start, "topic", "echo", "--once", "--filter", "m.theta > 1.78", "/turtle1/pose")
    end = start("zbot", "topic", "echo", "--filter", "m.linear_velocity == 0", "/turtle1/pose")
    end.wait_for("linear_velocity: 0.0")
    end.stop()
    reached = pose(start)
    assert (reached["x"], reached["y"], reached["theta"]) in (
        pytest.approx((6.6105, 6.9079, 1.7856), abs=1e-3),
        pytest.approx((6.6028, 6.9390, 1.8144), abs=1e-3),
    )


def test_turtles_are_spawned_and_killed(turtlesim: Program, start: Start) -> None:
    spawn = ("service", "call", "/spawn", "turtlesim/srv/Spawn")
    text = output(start, *spawn, "{x: 2, y: 2, theta: 0.2, name: ''}")
    assert "turtlesim.srv.Spawn_Response(name='turtle2')" in text
    assert "/turtle2/pose" in output(start, "topic", "list")
    output(start, "service", "call", "/kill", "turtlesim/srv/Kill", "{name: turtle2}")
    assert "/turtle2/pose" not in output(start, "topic", "list")
    output(start, "service", "call", "/reset", "std_srvs/srv/Empty")
    turtlesim.wait_for("Resetting turtlesim.")
    turtlesim.wait_for("Spawning turtle [turtle1]")


def test_a_turtle_turns_to_a_heading(turtlesim: Program, start: Start) -> None:
    text = output(
        start,
        *("action", "send_goal", "--feedback", "/turtle1/rotate_absolute"),
        *("turtlesim/action/RotateAbsolute", "{theta: 1.57}"),
    )
    assert "Goal finished with status: SUCCEEDED" in text
    (delta,) = re.findall(r"delta: (\S+)", text)
    assert float(delta) == pytest.approx(-1.57, abs=0.02)
    turtlesim.wait_for("Rotation goal completed successfully")


def test_parameters_have_their_ranges(turtlesim: Program, start: Start) -> None:
    assert turtlesim.process.poll() is None
    assert output(start, "param", "get", "/turtlesim", "background_b") == "Integer value is: 255"
    output(start, "param", "set", "/turtlesim", "background_b", "0")
    refused = start("zbot", "param", "set", "/turtlesim", "background_r", "256")
    assert refused.wait() == 1
    assert "256" in refused.output


def test_turtlesim_continues_after_a_turtle_hits_the_wall(turtlesim: Program, start: Start) -> None:
    for theta in ("0.0", "1.57"):
        where = f"{{x: 11.0, y: 11.0, theta: {theta}}}"
        teleport = ("/turtle1/teleport_absolute", "turtlesim/srv/TeleportAbsolute", where)
        output(start, "service", "call", *teleport)
        command = ("/turtle1/cmd_vel", "geometry_msgs/msg/Twist", "{linear: {x: 2.0}}")
        output(start, "topic", "pub", "--once", *command)
        turtlesim.wait_for("Oh no! I hit the wall! (Clamping from ")
    output(start, "service", "call", "/spawn", "turtlesim/srv/Spawn", "{name: turtle1}")
    turtlesim.wait_for("A turtle named [turtle1] already exists")


@pytest.mark.parametrize("name", ["a b", "1st", "dash-ed"])
def test_an_invalid_turtle_name_is_refused(turtlesim: Program, start: Start, name: str) -> None:
    text = output(start, "service", "call", "/spawn", "turtlesim/srv/Spawn", f"{{name: '{name}'}}")
    assert "turtlesim.srv.Spawn_Response(name='')" in text
    turtlesim.wait_for(f"A turtle cannot be named [{name}]")
    assert "turtlesim.srv.Spawn_Response(name='turtle2')" in output(
        start, "service", "call", "/spawn", "turtlesim/srv/Spawn", "{x: 1, y: 1}"
    )
    assert turtlesim.stop() == -2


def test_a_square_is_drawn(turtlesim: Program, start: Start) -> None:
    square = start("zbot", "run", "turtlesim", "draw_square")
    square.wait_for("New goal [7.544445 5.544445, 0.000000]")
    turtlesim.wait_for("Resetting turtlesim.")
    square.wait_for("Reached goal")
    square.wait_for("New goal")


def test_a_turtle_mimics_another(turtlesim: Program, start: Start) -> None:
    output(start, "service", "call", "/spawn", "turtlesim/srv/Spawn", "{x: 5, y: 2, name: echo}")
    mimic = start(
        *("zbot", "run", "turtlesim", "mimic", "--ros-args"),
        *("-r", "input/pose:=turtle1/pose", "-r", "output/cmd_vel:=echo/cmd_vel"),
    )
    output(start, "topic", "echo", "--once", "/echo/cmd_vel")  # it hears the poses
    command = "{linear: {x: 2.0}}"
    output(start, "topic", "pub", "--once", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", command)
    output(start, "topic", "echo", "--once", "--filter", "m.x > 6", "/echo/pose")
    assert mimic.stop() == -2
    assert turtlesim.process.poll() is None
