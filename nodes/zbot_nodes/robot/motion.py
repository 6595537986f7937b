"""Motion of the robot: as commanded, except through walls."""

from __future__ import annotations

import math
from typing import Protocol

from zbot.errors import MissingPackageError
from zbot_nodes.robot.pose import Pose, turn_to
from zbot_nodes.robot.state import PERIOD_S, WHEEL_DISTANCE_M, WHEEL_RADIUS_M, State
from zbot_nodes.robot.world import is_free


class Motion(Protocol):
    """How the robot moves."""

    def move(self, speed: float, turn: float) -> State:
        """Move for one period with a wanted speed in m/s and a wanted turn in rad/s."""
        ...


def new_motion() -> Motion:
    """Return a motion on real physics if the extra `sim` is installed, else a simple one."""
    from zbot_nodes.robot.physics import PhysicalMotion  # noqa: PLC0415 - it needs the extra

    try:
        return PhysicalMotion()
    except MissingPackageError:
        return SimpleMotion()


class SimpleMotion:
    """Motion without mass: the robot has each commanded velocity at once."""

    def __init__(self) -> None:
        self.pose = Pose()
        self.wheels = [0.0, 0.0]

    def move(self, speed: float, turn: float) -> State:
        """Turn, and move ahead unless a wall is there."""
        x, y, yaw = self.pose
        yaw = turn_to(yaw + turn * PERIOD_S)
        ahead_x = x + speed * PERIOD_S * math.cos(yaw)
        ahead_y = y + speed * PERIOD_S * math.sin(yaw)
        is_blocked = not is_free(ahead_x, ahead_y)
        speed = 0.0 if is_blocked else speed
        self.pose = Pose(x, y, yaw) if is_blocked else Pose(ahead_x, ahead_y, yaw)
        for wheel, side in enumerate((-1, 1)):
            velocity = (speed + side * turn * WHEEL_DISTANCE_M / 2) / WHEEL_RADIUS_M
            self.wheels[wheel] += velocity * PERIOD_S
        return State(self.pose, speed, turn, (self.wheels[0], self.wheels[1]), is_blocked)
