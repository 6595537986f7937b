"""Battery: its charge, which the electronics and the motion of a robot use up."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from zbot.simulation.robots.equipment import Battery
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

_S_PER_H = 3600.0
#: An empty battery has this share of its full voltage.
_EMPTY_SHARE = 0.85


class Charge(NamedTuple):
    """State of a battery."""

    voltage: float  #: volts
    current: float  #: amperes. As in ROS 2, it is negative while the battery is used
    charge: float  #: ampere hours
    share: float  #: of the full battery, 0 to 1


class BatteryMeter:
    """Battery of one robot. The robot goes on driving when it is empty.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: Battery, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number
        self._used_ah, self._last_ns = 0.0, 0

    def measure(self, world: World) -> Charge:
        """Return the charge. The robot has used the present current since the last measurement."""
        spec = self.spec
        linear, angular = self._robot.velocity
        motion = float(np.linalg.norm(linear[:2])) + spec.turn_share * abs(float(angular[2]))
        current = spec.idle_current + spec.motion_current * motion
        # After a reset of the world, the battery is full.
        if world.time_ns < self._last_ns:
            self._used_ah, self._last_ns = 0.0, 0
        passed_s = (world.time_ns - self._last_ns) / 1e9
        self._last_ns = world.time_ns
        self._used_ah = min(self._used_ah + current * passed_s / _S_PER_H, spec.capacity)
        share = 1 - self._used_ah / spec.capacity
        voltage = spec.voltage * (_EMPTY_SHARE + (1 - _EMPTY_SHARE) * share)
        if spec.noise:
            voltage += float(world.noise(self._robot, self._number).normal(0.0, spec.noise))
        return Charge(voltage, -current, spec.capacity - self._used_ah, share)
