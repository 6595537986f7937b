"""Tests of robots with four driven wheels, which slide sideways when the robot turns."""

from __future__ import annotations

import math

import pytest

from tests.unit.simulation.conftest import yaw_of
from zbot.simulation.robots.model import GazeboPlace, read_robot
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan
from zbot.tf2.rigid import Rigid

_RADIUS = 0.05
_CORNERS = {"fl": (1, 1), "fr": (1, -1), "rl": (-1, 1), "rr": (-1, -1)}
_BODY = (
    "<link name='base'><inertial><mass value='5'/><inertia ixx='0.05' iyy='0.1' izz='0.12'/>"
    "</inertial></link>"
)
_WHEEL = (
    "<link name='{0}'><inertial><mass value='0.3'/><inertia ixx='2e-4' iyy='4e-4' izz='2e-4'/>"
    "</inertial><collision><origin rpy='1.5707963 0 0'/><geometry><cylinder radius='0.05' "
    "length='0.03'/></geometry></collision></link><joint name='{0}_joint' type='continuous'>"
    "<parent link='base'/><child link='{0}'/><origin xyz='{1} {2} 0'/><axis xyz='0 1 0'/></joint>"
)
_JOINT = "<joint name='{0}_joint'><command_interface name='velocity'/></joint>"


def skid_robot(length: float, width: float) -> World:
    """Return a world with a robot, whose wheels have these distances."""
    wheels = (
        _WHEEL.format(name, x * length / 2, y * width / 2) for name, (x, y) in _CORNERS.items()
    )
    joints = "".join(map(_JOINT.format, _CORNERS))
    control = f"<ros2_control name='c' type='system'>{joints}</ros2_control>"
    plugin = "<gazebo><plugin filename='gz_ros2_control-system' name='c'/></gazebo>"
    text = f"<robot name='r'>{_BODY}{''.join(wheels)}{control}{plugin}</robot>"
    world = World(Plan().spec())
    world.add([("r", read_robot(text, GazeboPlace("r", "w")), Rigid())])
    return world


def drive(world: World, left: float, right: float, seconds: float) -> float:
    """Turn the wheels with these speeds in m/s. Return how far the robot turns, in radians."""
    robot, turned = world.robots["r"], 0.0
    for name, (_, y) in _CORNERS.items():
        speed = left if y > 0 else right
        robot.joint_motors.command(f"{name}_joint", "velocity", speed / _RADIUS)
    for _ in range(round(seconds / world.step_s)):
        before = yaw_of(robot.pose)
        world.step()
        turned += math.remainder(yaw_of(robot.pose) - before, math.tau)
    return turned


@pytest.mark.parametrize(("length", "width"), [(0.1, 0.4), (0.17, 0.25), (0.2, 0.3)])
def test_a_robot_on_four_wheels_turns_as_its_friction_lets_it(length: float, width: float) -> None:
    """The wheels push forward at half the width, and the floor holds them at half the length.

    Both moments are equal if the robot turns by width^2 / (width^2 + length^2) of what it would
    without sliding.
    """
    world, turn = skid_robot(length, width), 1.5
    drive(world, -turn * width / 2, turn * width / 2, 0.6)
    turned = drive(world, -turn * width / 2, turn * width / 2, 4.0)
    expected = width**2 / (width**2 + length**2)
    assert turned / (4 * turn) == pytest.approx(expected, rel=0.2)


def test_a_robot_on_four_wheels_drives_straight_as_fast_as_its_wheels() -> None:
    world = skid_robot(0.17, 0.25)
    drive(world, 0.4, 0.4, 0.6)
    robot = world.robots["r"]
    before = robot.pose.translation[0]
    assert abs(drive(world, 0.4, 0.4, 2.0)) < 0.02
    assert robot.pose.translation[0] - before == pytest.approx(0.8, rel=0.03)
