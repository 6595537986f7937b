"""Sight of a robot in a world: what goals look at."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.robots.equipment import Lidar

if TYPE_CHECKING:
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

_RAYS = 120
#: A contact whose direction is steeper than this is one with the floor.
_STEEP = 0.7


class Sight:
    """True state of one robot in a world, after the present step.

    Args:
        world: The world.
        robot: The robot.

    Attributes:
        way_m: How far the robot has driven since the start.
    """

    def __init__(self, world: World, robot: Robot) -> None:
        self._world, self._robot = world, robot
        sensors = robot.model.equipment.sensors
        lidar = next((sensor for sensor in sensors if isinstance(sensor, Lidar)), None)
        self._link = lidar.link if lidar is not None else robot.model.tree.root
        angles = np.arange(_RAYS) * (2 * math.pi / _RAYS)
        self._rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(_RAYS)], axis=1)
        self._gap: tuple[int, float] = (-1, math.inf)
        self._at = self.place
        self.way_m = 0.0

    def advance(self) -> None:
        """Add the way of the present step."""
        before, self._at = self._at, self.place
        self.way_m += math.dist(before, self._at)

    @property
    def now_s(self) -> float:
        """The time in the world."""
        return self._world.time_ns / 1e9

    @property
    def place(self) -> tuple[float, float]:
        """The true place of the robot."""
        x, y, _ = self._robot.pose.translation
        return x, y

    @property
    def stands(self) -> bool:
        """Whether the robot neither drives nor turns."""
        linear, angular = self._robot.velocity
        return float(np.abs(linear).max()) < 0.01 and float(np.abs(angular).max()) < 0.05

    @property
    def gap_m(self) -> float:
        """The distance from the robot's lidar to the nearest obstacle around it, without noise."""
        if self._gap[0] != self._world.steps:
            origin = np.array(self._robot.link_pose(self._link).translation)
            distances, _, _ = self._world.cast(origin, self._rays, unseen=self._robot)
            nearest = float(np.where(distances < 0, math.inf, distances).min())
            self._gap = (self._world.steps, nearest)
        return self._gap[1]

    @property
    def touched(self) -> str:
        """The name of what the robot touches, except for the floor. Empty means nothing."""
        contacts = self._world.data.contact
        own = np.isin(contacts.geom, self._robot.geoms)
        for row in np.flatnonzero(own.any(axis=1)).tolist():
            if abs(float(contacts.frame[row, 2])) < _STEEP:
                other = contacts.geom[row, 0 if own[row, 1] else 1]
                return self._world.name_of(int(other))
        return ""
