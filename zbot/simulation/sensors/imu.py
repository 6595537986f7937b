"""Inertial sensor: the orientation, the turn and the acceleration of a link."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from zbot.simulation.rotation import to_matrix

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.equipment import Imu
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World
    from zbot.tf2.rigid import Quaternion

    Array = NDArray[np.float64]


class Reading(NamedTuple):
    """What the sensor measures, in its own axes."""

    orientation: Quaternion  #: in the world
    turn: Array  #: rad/s
    acceleration: Array  #: m/s^2. At rest, it is the opposite of the gravity


class InertialSensor:
    """Inertial sensor of one robot.

    The acceleration is the mean since the last measurement, so that short shocks do not vanish.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: Imu, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number
        self._last: tuple[int, Array] | None = None  # the time and the velocity

    def measure(self, world: World) -> Reading:
        """Return a measurement, with noise."""
        pose = self._robot.link_pose(self.spec.link)
        linear, angular = self._robot.link_velocity(self.spec.link)
        last_ns, before = self._last or (0, linear)
        self._last = (world.time_ns, linear)
        passed_s = (world.time_ns - last_ns) / 1e9
        # If nobody has listened for a time, the mean over this time would say nothing.
        is_recent = 0 < passed_s < 2 / self.spec.rate_hz
        gain = (linear - before) / passed_s if is_recent else np.zeros(3)
        back = to_matrix(pose).T
        random = world.noise(self._robot, self._number)
        return Reading(
            pose.rotation,
            back @ angular + random.normal(0.0, self.spec.turn_noise, 3),
            back @ (gain - world.model.opt.gravity) + random.normal(0.0, self.spec.noise, 3),
        )
