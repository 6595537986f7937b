"""Bumper: what a link of a robot touches."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from zbot.simulation.robots.equipment import Bumper
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World
    from zbot.tf2.rigid import Vector


class Touch(NamedTuple):
    """Contact of a link, in the world."""

    other: str  #: name of what it touches
    point: Vector  #: metres
    normal: Vector  #: direction from the other thing to the link
    depth: float  #: how far they are in each other, in metres


class BumperSensor:
    """Bumper of one robot. Other links of the same robot do not count.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
    """

    def __init__(self, spec: Bumper, robot: Robot) -> None:
        self.spec, self._robot = spec, robot

    def measure(self, world: World) -> list[Touch]:
        """Return the present contacts."""
        contacts = world.data.contact
        pairs = contacts.geom
        own = self._robot.geoms_of(self.spec.link)
        touched = np.isin(pairs, own)
        found = []
        for row in np.flatnonzero(touched.any(axis=1)).tolist():
            is_second = bool(touched[row, 1])
            normal = contacts.frame[row, :3] * (1 if is_second else -1)
            found.append(
                Touch(
                    world.name_of(int(pairs[row, 0 if is_second else 1])),
                    tuple(contacts.pos[row].tolist()),
                    tuple(normal.tolist()),
                    max(0.0, -float(contacts.dist[row])),
                )
            )
        return found
