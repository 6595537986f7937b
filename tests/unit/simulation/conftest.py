"""Fixtures of the tests of the simulator: worlds with robots, without nodes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

from zbot.simulation.gazebo.equipment import read_equipment, urdf_tags
from zbot.simulation.gazebo.names import PlainNames
from zbot.simulation.robots.catalog import find_robot
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan
from zbot.tf2.rigid import Rigid, heading

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.simulation.robots.equipment import Equipment
    from zbot.simulation.robots.robot import Robot

    MakeWorld = Callable[..., World]

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")


def turned(x: float, y: float, yaw: float, z: float = 0.0) -> Rigid:
    """Return a pose on the floor."""
    return Rigid((x, y, z), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))


def tags_of(text: str) -> Equipment:
    """Return the equipment that the `<gazebo>` tags of a robot description name."""
    return read_equipment(urdf_tags(text), PlainNames(), "")


def yaw_of(pose: Rigid) -> float:
    """Return the heading of a pose."""
    return heading(pose.rotation)


@pytest.fixture
def make_world() -> MakeWorld:
    """Return a function that makes a world from a plan, with two-wheeled robots at these poses."""

    def make(
        plan: Plan | None = None, *poses: Rigid, robot: str = "two_wheeled", **options: Any
    ) -> World:
        world = World((plan or Plan()).spec(), **options)
        model = find_robot(robot)
        world.add((f"robot{number}", model, pose) for number, pose in enumerate(poses, start=1))
        return world

    return make


def run(world: World, seconds: float) -> None:
    """Move a world for some time."""
    for _ in range(round(seconds / world.step_s)):
        world.step()


def drive(world: World, robot: Robot, forward: float, turn: float, seconds: float) -> None:
    """Drive a robot for some time."""
    robot.command = (forward, 0.0, turn)
    run(world, seconds)
