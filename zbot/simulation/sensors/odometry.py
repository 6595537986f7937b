"""Odometry: the pose and the velocity of a robot, as its wheels tell them.

Wheels slip, so this pose drifts away from the true one.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot.tf2.rigid import Rigid

if TYPE_CHECKING:
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World


class WheelOdometry:
    """Odometry of one robot, which begins where the robot starts.

    Attributes:
        speed: The velocity forward and to the left in m/s, and the turn in rad/s.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self.x, self.y, self.heading = 0.0, 0.0, 0.0
        self.speed = (0.0, 0.0, 0.0)
        self._last_ns = 0

    @property
    def pose(self) -> Rigid:
        """The pose in the frame of the odometry."""
        half = self.heading / 2
        return Rigid((self.x, self.y, 0.0), (0.0, 0.0, math.sin(half), math.cos(half)))

    def measure(self, world: World) -> None:
        """Add the way since the last measurement."""
        forward, left, turn = self._robot.motors.travelled(self._robot, world.data)
        # A robot that turns moves along an arc. Its chord has the middle direction.
        half = turn / 2
        chord = math.sin(half) / half if abs(half) > 1e-9 else 1.0
        cos, sin = chord * math.cos(self.heading + half), chord * math.sin(self.heading + half)
        self.x += forward * cos - left * sin
        self.y += forward * sin + left * cos
        self.heading += turn
        passed_s = (world.time_ns - self._last_ns) / 1e9
        self._last_ns = world.time_ns
        if passed_s > 0:
            self.speed = (forward / passed_s, left / passed_s, turn / passed_s)

    def reset(self) -> None:
        """Begin again at the robot's present pose."""
        self.x, self.y, self.heading = 0.0, 0.0, 0.0
        self.speed, self._last_ns = (0.0, 0.0, 0.0), 0
