"""Two robots with one program each, on two machines that just want each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.classroom.rig import Rig, obstacle

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.classroom.machine import Machine

LAUNCH = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    robot = LaunchConfiguration("robot")
    return LaunchDescription([
        DeclareLaunchArgument("robot", description="Its name, which is its namespace"),
        DeclareLaunchArgument("part", default_value="engine"),
        Node(
            package="zbot_nodes",
            executable="sensor",
            name=[LaunchConfiguration("part"), "_sensor"],
            namespace=robot,
            remappings=[("temperature", "heat")],
        ),
    ])
"""


@pytest.fixture(scope="module")
def machines() -> Iterator[tuple[Machine, Machine]]:
    """A desk with a hub, a laptop that joined it, and a robot on each."""
    reason = obstacle()
    if reason is not None:
        pytest.skip(reason)
    with Rig(1) as rig:
        desk, laptop = rig.teacher, rig.laptops[0]
        desk.start("zbot", "hub").wait_for("zbot join")
        joined = laptop.run("zbot", "join", desk.address)
        assert joined.code == 0, joined.err
        for machine, words in ((desk, ["robot:=ana"]), (laptop, ["robot:=ben", "part:=arm"])):
            (machine.home / "robot.launch.py").write_text(LAUNCH, encoding="utf-8")
            launched = machine.start("zbot", "launch", "robot.launch.py", *words)
            launched.wait_for("Temperature:")
        yield desk, laptop


def test_each_robot_has_its_own_names(machines: tuple[Machine, Machine]) -> None:
    for machine in machines:
        assert machine.run("zbot", "node", "list").out.split() == [
            "/ana/engine_sensor",
            "/ben/arm_sensor",
        ]
        topics = machine.run("zbot", "topic", "list").out.split()
        assert {"/ana/heat", "/ben/heat"} <= set(topics)
        assert not [topic for topic in topics if "temperature" in topic]


def test_a_program_hears_the_robot_in_whose_namespace_it_is(
    machines: tuple[Machine, Machine],
) -> None:
    desk, laptop = machines
    rules = ["--ros-args", "-r", "__ns:=/ben", "-r", "temperature:=heat"]

    for machine in (desk, laptop):
        monitor = machine.start("zbot", "run", "monitor", *rules)
        monitor.wait_for("°C")
        info = laptop.run("zbot", "topic", "info", "/ben/heat").out
        assert "Subscription count: 1" in info
        assert "Subscription count: 0" in desk.run("zbot", "topic", "info", "/ana/heat").out
        monitor.stop()


def test_commands_reach_the_other_machines_robot(machines: tuple[Machine, Machine]) -> None:
    desk, laptop = machines

    echoed = desk.run("zbot", "topic", "echo", "--once", "/ben/heat")
    assert echoed.out.startswith("data: ")
    listed = desk.run("zbot", "param", "list", "/ben/arm_sensor")
    assert "use_sim_time" in listed.out
    changed = laptop.run("zbot", "param", "set", "/ana/engine_sensor", "use_sim_time", "true")
    assert changed.code == 0, changed.err
    back = laptop.run("zbot", "param", "set", "/ana/engine_sensor", "use_sim_time", "false")
    assert back.code == 0, back.err


def test_a_turtle_is_driven_from_the_other_machine(machines: tuple[Machine, Machine]) -> None:
    desk, laptop = machines
    turtle = laptop.start("zbot", "run", "turtlesim_node", "--ros-args", "-r", "__ns:=/ben")
    turtle.wait_for("Spawning turtle")

    spawn = "{x: 2.0, y: 2.0, theta: 0.0, name: 'cleo'}"
    called = desk.run("zbot", "service", "call", "/ben/spawn", "turtlesim/srv/Spawn", spawn)
    assert "name='cleo'" in called.out
    turn = ("/ben/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute", "{theta: 1.0}")
    turned = desk.run("zbot", "action", "send_goal", *turn)
    assert "SUCCEEDED" in turned.out
    turtle.stop()
