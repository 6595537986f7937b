"""Tests of arms: their motors reach positions, follow trajectories, and hold the arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.unit.simulation.conftest import run, turned
from zbot.simulation.robots.arm import arm_joints
from zbot.simulation.robots.catalog import find_robot

if TYPE_CHECKING:
    from tests.unit.simulation.conftest import MakeWorld
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

HOME = [0.0] * 6


@pytest.fixture
def world(make_world: MakeWorld) -> World:
    """Return a world with an arm."""
    return make_world(None, turned(0, 0, 0), robot="arm")


@pytest.fixture
def arm(world: World) -> Robot:
    """Return the arm."""
    return world.robots["robot1"]


def test_an_arm_stands_upright_and_holds_its_weight(world: World, arm: Robot) -> None:
    run(world, 2.0)
    assert arm.joint_states()[1] == pytest.approx(HOME, abs=1e-3)
    assert arm.link_pose("hand").translation == pytest.approx((0, 0, 0.48), abs=0.01)


def test_an_arm_reaches_positions_and_stays_inside_its_limits(world: World, arm: Robot) -> None:
    assert arm.arm is not None
    arm.arm.go([1.0, 0.5, -5.0, 0.3, 0.02, 9.0])
    run(world, 3.0)
    _, positions, velocities = arm.joint_states()
    assert positions == pytest.approx([1.0, 0.5, -2.2, 0.3, 0.02, 0.025], abs=0.01)
    assert velocities == pytest.approx(HOME, abs=0.01)


def test_an_arm_follows_a_trajectory_in_its_time(world: World, arm: Robot) -> None:
    assert arm.arm is not None
    arm.arm.follow([(1.0, [0.4, 0.2, 0, 0, 0, 0]), (3.0, [0.4, 0.2, 1.0, 0, 0, 0])])
    run(world, 0.5)
    assert arm.joint_states()[1][:2] == pytest.approx([0.2, 0.1], abs=0.03)
    run(world, 1.5)
    assert arm.joint_states()[1][:3] == pytest.approx([0.4, 0.2, 0.5], abs=0.03)
    run(world, 1.5)
    assert arm.joint_states()[1][2] == pytest.approx(1.0, abs=0.01)


def test_a_reset_brings_an_arm_home(world: World, arm: Robot) -> None:
    assert arm.arm is not None
    arm.arm.go([1.0, 0.5, 0.5, 0.3, 0.0, 0.0])
    run(world, 1.0)
    world.reset()
    run(world, 1.0)
    assert arm.joint_states()[1] == pytest.approx(HOME, abs=1e-3)


def test_a_robot_with_wheels_is_no_arm() -> None:
    assert arm_joints(find_robot("two_wheeled")) == []
    assert len(arm_joints(find_robot("arm"))) == 6
