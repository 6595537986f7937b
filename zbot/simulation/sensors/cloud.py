"""Lidar with several rows of rays, which measures points in space."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.sensors.rays import cast

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.equipment import CloudLidar
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World


class CloudScanner:
    """Lidar of one robot with several rows of rays. It does not see the robot itself.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: CloudLidar, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number
        around = np.linspace(spec.first_angle, spec.last_angle, spec.rays)
        up = np.linspace(spec.lowest_angle, spec.highest_angle, spec.rows)
        turn, lift = np.meshgrid(around, up)
        x, y, z = np.cos(lift) * np.cos(turn), np.cos(lift) * np.sin(turn), np.sin(lift)
        self._rays = np.stack([x, y, z], axis=-1).reshape(-1, 3)

    def measure(self, world: World) -> NDArray[np.float32]:
        """Return a point for each ray: x, y and z in metres in the frame of the link.

        The points are in rows, the lowest first. A ray that hits nothing in reach has NaN.
        """
        spec = self.spec
        distances = cast(world, self._robot, spec.link, self._rays).distances
        is_hit = (distances >= spec.nearest) & (distances <= spec.farthest)
        if spec.noise:
            random = world.noise(self._robot, self._number)
            distances += random.normal(0.0, spec.noise, len(distances))
        found: NDArray[np.float32] = np.where(is_hit, distances, np.nan)[:, None] * self._rays
        return found.astype(np.float32)
