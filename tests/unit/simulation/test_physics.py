"""Tests of the physics against formulas: falling, sliding, rolling and driving."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tests.unit.simulation.conftest import drive, run, turned, yaw_of
from zbot.simulation.engine import engine, new_spec
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan, add_floor
from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from tests.unit.simulation.conftest import MakeWorld

GRAVITY = 9.81


def world_with(kind: str, **geom: Any) -> World:
    """Return a world with a floor and one body."""
    spec = new_spec()
    add_floor(spec)
    body = spec.worldbody.add_body(
        name="thing", pos=geom.pop("pos"), quat=geom.pop("quat", (1, 0, 0, 0))
    )
    body.add_freejoint()
    body.add_geom(type=getattr(engine().mjtGeom, f"mjGEOM_{kind}"), mass=1.0, **geom)
    return World(spec)


def test_a_body_falls_as_the_formula_says() -> None:
    world = world_with("SPHERE", pos=(0, 0, 10), size=(0.1, 0, 0))
    run(world, 1.0)
    assert world.things["thing"].pose.translation[2] == pytest.approx(10 - GRAVITY / 2, abs=0.025)
    linear, _ = world.things["thing"].velocity
    assert linear[2] == pytest.approx(-GRAVITY, rel=1e-3)


def test_a_box_slides_as_far_as_its_friction_lets_it() -> None:
    world = world_with("BOX", pos=(0, 0, 0.05), size=(0.2, 0.2, 0.05), friction=(1, 0.005, 1e-4))
    world.things["thing"].set_velocity(np.array([2.0, 0.0, 0.0]), np.zeros(3))
    run(world, 2.0)
    assert world.things["thing"].pose.translation[0] == pytest.approx(4 / (2 * GRAVITY), rel=0.05)


def test_a_ball_rolls_without_losing_speed() -> None:
    world = world_with("SPHERE", pos=(0, 0, 0.1), size=(0.1, 0, 0), friction=(1, 0, 0))
    world.things["thing"].set_velocity(np.array([1.0, 0.0, 0.0]), np.array([0.0, 10.0, 0.0]))
    run(world, 2.0)
    assert world.things["thing"].pose.translation[0] == pytest.approx(2.0, rel=0.01)


@pytest.mark.parametrize(
    ("forward", "turn"), [(0.3, 0.0), (-0.2, 0.0), (0.0, 1.0), (0.3, 0.8), (0.2, -1.2)]
)
def test_a_two_wheeled_robot_drives_the_commanded_arc(
    make_world: MakeWorld, forward: float, turn: float
) -> None:
    world = make_world(None, turned(0, 0, 0.5))
    robot = world.robots["robot1"]
    drive(world, robot, forward, turn, 1.5)  # it speeds up
    start = robot.pose
    drive(world, robot, forward, turn, 2.0)
    moved = start.inverse() @ robot.pose
    angle = turn * 2.0
    radius = forward / turn if turn else 0.0
    x, y = (
        (radius * math.sin(angle), radius * (1 - math.cos(angle))) if turn else (forward * 2, 0.0)
    )
    assert moved.translation[0] == pytest.approx(x, abs=0.01)
    assert moved.translation[1] == pytest.approx(y, abs=0.01)
    assert yaw_of(moved) == pytest.approx(math.atan2(math.sin(angle), math.cos(angle)), abs=0.015)


def test_a_robot_speeds_up_with_the_acceleration_of_its_description(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0))
    robot = world.robots["robot1"]
    drive(world, robot, 0.5, 0.0, 0.2)  # at 2 m/s^2
    assert robot.velocity[0][0] == pytest.approx(0.4, abs=0.06)


def test_a_wall_stops_a_robot_whose_wheels_slip(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.wall((0.5, -1.0), (0.5, 1.0))
    world = make_world(plan, turned(0, 0, 0))
    robot = world.robots["robot1"]
    robot.motors.travelled(robot, world.data)
    drive(world, robot, 0.3, 0.0, 4.0)
    assert robot.pose.translation[0] < 0.45
    forward, _, _ = robot.motors.travelled(robot, world.data)
    assert forward > robot.pose.translation[0] + 0.2, "the odometry does not drift"


def test_robots_push_what_is_light(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.box(0.4, 0.0, (0.2, 0.2, 0.2), mass=0.2, name="box1")
    world = make_world(plan, turned(0, 0, 0))
    drive(world, world.robots["robot1"], 0.3, 0.0, 3.0)
    assert world.things["box1"].pose.translation[0] > 0.5


def test_robots_do_not_pass_through_each_other(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0), turned(1, 0, math.pi))
    first, second = world.robots.values()
    first.command = second.command = (0.2, 0.0, 0.0)
    run(world, 5.0)
    assert second.pose.translation[0] - first.pose.translation[0] > 0.155, (
        "their bodies are 0.16 m apart"
    )


def test_the_same_seed_gives_the_same_run(make_world: MakeWorld) -> None:
    states = []
    for _ in range(2):
        plan = Plan()
        plan.box(0.4, 0.05, (0.2, 0.2, 0.2), mass=0.2, name="box1")
        world = make_world(plan, turned(0, 0, 0), turned(0, 1, 0), seed=3)
        for robot in world.robots.values():
            robot.command = (0.3, 0.0, 0.4)
        run(world, 3.0)
        states.append(world.data.qpos.tobytes())
    assert states[0] == states[1]


def test_a_reset_puts_everything_back(make_world: MakeWorld) -> None:
    world = make_world(None, turned(1, 2, 0.5))
    robot = world.robots["robot1"]
    start = robot.pose
    drive(world, robot, 0.3, 0.5, 1.0)
    world.reset()
    assert robot.pose == start
    run(world, 0.5)
    assert robot.pose.translation == pytest.approx(start.translation, abs=1e-3)


def test_robots_come_and_go_while_others_drive(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0))
    robot = world.robots["robot1"]
    drive(world, robot, 0.3, 0.0, 1.0)
    before = robot.pose
    world.add([("other", robot.model, turned(0, 2, 0))])
    assert robot.pose == before
    world.remove("robot1")
    assert list(world.robots) == ["other"]
    drive(world, world.robots["other"], 0.3, 0.0, 1.0)
    assert world.robots["other"].pose.translation[0] > 0.2


def test_a_robot_stands_on_its_wheels_from_the_start(make_world: MakeWorld) -> None:
    world = make_world(None, Rigid((0.0, 0.0, 0.0)))
    before = world.robots["robot1"].pose.translation[2]
    run(world, 1.0)
    assert world.robots["robot1"].pose.translation[2] == pytest.approx(before, abs=1e-3)
