"""Rays of a sensor through the world."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from zbot.simulation.rotation import to_matrix

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

    Floats = NDArray[np.float64]


class Echoes(NamedTuple):
    """What rays hit, in the axes of the world."""

    origin: Floats  #: where the rays begin
    rays: Floats  #: their directions
    distances: Floats  #: metres; -1 without a hit
    hits: NDArray[np.int32]  #: numbers of the solids; -1 without a hit
    normals: Floats  #: of the surfaces


def cast(world: World, robot: Robot, link: str, rays: Floats) -> Echoes:
    """Send rays from a link of a robot. They do not hit the robot.

    Args:
        world: The world.
        robot: The robot.
        link: The link.
        rays: The directions with the length 1, in the axes of the link, one in a row.
    """
    pose = robot.link_pose(link)
    origin, turned = np.array(pose.translation), rays @ to_matrix(pose).T
    return Echoes(origin, turned, *world.cast(origin, turned, unseen=robot))
