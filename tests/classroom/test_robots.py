"""Two robots with one program each, on two machines with a plain hub."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.classroom.conftest import skip_without_namespaces
from tests.classroom.testbed import LanTestbed

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
    """A machine with a hub, a laptop that joined it, and a robot on each."""
    skip_without_namespaces()
    with LanTestbed(1) as testbed:
        hub_machine, laptop = testbed.teacher, testbed.laptops[0]
        hub_machine.start("zbot", "hub").wait_for("zbot join")
        joined = laptop.run("zbot", "join", hub_machine.address)
        assert joined.code == 0, joined.err
        for machine, words in (
            (hub_machine, ["robot:=ana"]),
            (laptop, ["robot:=ben", "part:=arm"]),
        ):
            (machine.home / "robot.launch.py").write_text(LAUNCH, encoding="utf-8")
            launched = machine.start("zbot", "launch", "robot.launch.py", *words)
            launched.wait_for("Temperature:")
        yield hub_machine, laptop


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
    hub_machine, laptop = machines
    rules = ["--ros-args", "-r", "__ns:=/ben", "-r", "temperature:=heat"]

    for machine in (hub_machine, laptop):
        monitor = machine.start("zbot", "run", "monitor", *rules)
        monitor.wait_for("°C")
        info = laptop.run("zbot", "topic", "info", "/ben/heat").out
        assert "Subscription count: 1" in info
        assert "Subscription count: 0" in hub_machine.run("zbot", "topic", "info", "/ana/heat").out
        monitor.stop()


def test_commands_reach_the_other_machines_robot(machines: tuple[Machine, Machine]) -> None:
    hub_machine, laptop = machines

    echoed = hub_machine.run("zbot", "topic", "echo", "--once", "/ben/heat")
    assert echoed.out.startswith("data: ")
    listed = hub_machine.run("zbot", "param", "list", "/ben/arm_sensor")
    assert "use_sim_time" in listed.out
    changed = laptop.run("zbot", "param", "set", "/ana/engine_sensor", "use_sim_time", "true")
    assert changed.code == 0, changed.err
    back = laptop.run("zbot", "param", "set", "/ana/engine_sensor", "use_sim_time", "false")
    assert back.code == 0, back.err


def test_a_turtle_is_driven_from_the_other_machine(machines: tuple[Machine, Machine]) -> None:
    hub_machine, laptop = machines
    turtle = laptop.start("zbot", "run", "turtlesim_node", "--ros-args", "-r", "__ns:=/ben")
    turtle.wait_for("Spawning turtle")

    spawn = "{x: 2.0, y: 2.0, theta: 0.0, name: 'cleo'}"
    called = hub_machine.run("zbot", "service", "call", "/ben/spawn", "turtlesim/srv/Spawn", spawn)
    assert "name='cleo'" in called.out
    turn = ("/ben/turtle1/rotate_absolute", "turtlesim/action/RotateAbsolute", "{theta: 1.0}")
    turned = hub_machine.run("zbot", "action", "send_goal", *turn)
    assert "SUCCEEDED" in turned.out
    turtle.stop()
