"""Sonar: the distance to the nearest thing in a cone, by rays."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.sensors.rays import cast

if TYPE_CHECKING:
    from zbot.simulation.robots.equipment import Sonar
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

_RINGS, _PER_RING = 3, 12
#: A surface that is steeper than this to a ray sends the sound away, e.g. the floor before a robot.
_LEAST_ECHO = 0.3


class SonarSensor:
    """Sonar of one robot. It looks along the x axis of its link, and does not see the robot.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: Sonar, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number
        rays = [(1.0, 0.0, 0.0)]
        for ring in range(1, _RINGS + 1):
            away = math.sin(spec.field_of_view / 2 * ring / _RINGS)
            ahead = math.sqrt(1 - away * away)
            for part in range(_PER_RING):
                angle = 2 * math.pi * part / _PER_RING
                rays.append((ahead, away * math.cos(angle), away * math.sin(angle)))
        self._rays = np.array(rays)

    def measure(self, world: World) -> float:
        """Return the distance in metres.

        As in REP 117, infinity means that nothing is in reach, and minus infinity that something is
        too near.
        """
        spec = self.spec
        _, rays, distances, _, normals = cast(world, self._robot, spec.link, self._rays)
        echoes = np.abs((rays * normals).sum(axis=1)) >= _LEAST_ECHO
        found = float(np.where((distances >= 0) & echoes, distances, math.inf).min())
        if spec.noise and math.isfinite(found):
            found += float(world.noise(self._robot, self._number).normal(0.0, spec.noise))
        if found > spec.farthest:
            return math.inf
        return -math.inf if found < spec.nearest else found
