"""Satellite receiver: the place of a link on the Earth."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from zbot.simulation.robots.equipment import Gps
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

#: Of the ellipsoid WGS 84: its longest radius in metres, and its first eccentricity squared.
_RADIUS_M, _ECCENTRICITY_2 = 6_378_137.0, 6.694_379_990_14e-3


class Fix(NamedTuple):
    """Place on the Earth."""

    latitude: float  #: degrees, north is positive
    longitude: float  #: degrees, east is positive
    altitude: float  #: metres above the ellipsoid


class GpsReceiver:
    """Satellite receiver of one robot. The x axis of the world points to the east, y to the north.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: Gps, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number

    def measure(self, world: World) -> Fix:
        """Return the place, with noise."""
        spec = self.spec
        x, y, z = self._robot.link_pose(spec.link).translation
        random = world.noise(self._robot, self._number)
        east, north = random.normal((x, y), spec.noise)
        up = random.normal(z, spec.height_noise)
        return place_on_earth(
            Fix(*(spec.origin or world.earth)), float(east), float(north), float(up)
        )


def place_on_earth(origin: Fix, east: float, north: float, up: float) -> Fix:
    """Return the place that is some metres away from an origin.

    The Earth is a plane here. Within a kilometre, the error is less than a decimetre.
    """
    at = math.radians(origin.latitude)
    shrunk = 1 - _ECCENTRICITY_2 * math.sin(at) ** 2
    along = _RADIUS_M * (1 - _ECCENTRICITY_2) / shrunk**1.5 + origin.altitude
    across = (_RADIUS_M / math.sqrt(shrunk) + origin.altitude) * math.cos(at)
    return Fix(
        origin.latitude + math.degrees(north / along),
        origin.longitude + math.degrees(east / across),
        origin.altitude + up,
    )
