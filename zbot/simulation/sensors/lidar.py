"""Lidar: distances in a circle around a robot, by rays through the world."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.sensors.rays import cast

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.equipment import Lidar
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World


class LidarScanner:
    """Lidar of one robot. It does not see the robot itself.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: Lidar, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number
        angles = np.linspace(spec.first_angle, spec.last_angle, spec.rays)
        self._rays = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=1)

    @property
    def increment(self) -> float:
        """The angle between two rays, in radians."""
        return (self.spec.last_angle - self.spec.first_angle) / max(self.spec.rays - 1, 1)

    def measure(self, world: World) -> NDArray[np.float32]:
        """Return the distance in each direction, in metres.

        As in REP 117, infinity means that nothing is in reach, and minus infinity that something is
        too near.
        """
        spec = self.spec
        distances = cast(world, self._robot, spec.link, self._rays).distances
        if spec.noise:
            hit = distances >= 0
            random = world.noise(self._robot, self._number)
            distances[hit] += random.normal(0.0, spec.noise, int(hit.sum()))
        found = distances.astype(np.float32)
        found[(distances < 0) | (distances > spec.farthest)] = np.inf
        found[(distances >= 0) & (distances < spec.nearest)] = -np.inf
        return found
