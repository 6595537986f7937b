"""Tests of how the simulated robot moves: on real physics, and without it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from zbot.errors import MissingPackageError
from zbot_nodes.robot import physics
from zbot_nodes.robot.motion import SimpleMotion, new_motion

if TYPE_CHECKING:
    from zbot_nodes.robot.motion import Motion
    from zbot_nodes.robot.state import State


def drive(motion: Motion, speed: float, turn: float, periods: int) -> State:
    """Move for some periods."""
    state = motion.move(speed, turn)
    for _ in range(periods - 1):
        state = motion.move(speed, turn)
    return state


@pytest.fixture(params=["simple", "physical"])
def motion(request: pytest.FixtureRequest) -> Motion:
    """Return each kind of motion."""
    if request.param == "simple":
        return SimpleMotion()
    pytest.importorskip("mujoco", reason="real physics needs the extra `sim`")
    return physics.PhysicalMotion()


def test_the_robot_drives_as_commanded(motion: Motion) -> None:
    drive(motion, 0.5, 0.0, 50)
    before = motion.move(0.5, 0.0)
    after = drive(motion, 0.5, 0.0, 50)
    assert after.pose.x - before.pose.x == pytest.approx(0.5, abs=0.01)
    assert after.speed == pytest.approx(0.5, abs=0.01)
    assert after.wheels[0] - before.wheels[0] == pytest.approx(10.0, abs=0.2)
    assert not after.is_blocked


def test_the_robot_turns_to_the_left(motion: Motion) -> None:
    state = drive(motion, 0.0, 1.0, 60)
    assert state.pose.yaw == pytest.approx(1.2, abs=0.1)
    assert state.turn == pytest.approx(1.0, abs=0.01)


def test_a_wall_stops_the_robot(motion: Motion) -> None:
    state = drive(motion, 1.0, 0.0, 300)
    assert state.is_blocked
    assert state.pose.x == pytest.approx(3.79, abs=0.02)


def test_without_the_extra_the_motion_is_simple(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> None:
        raise MissingPackageError("the simulator", "MuJoCo", "sim")

    monkeypatch.setattr(physics, "engine", missing)
    assert isinstance(new_motion(), SimpleMotion)
