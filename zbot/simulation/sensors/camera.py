"""Camera: colour and depth images, by a ray for each pixel. It needs no graphics card."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from zbot.simulation.sensors.rays import cast

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.simulation.robots.equipment import Camera
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World

_SKY = (170.0, 210.0, 250.0)
#: The direction to the light, and the share of the light that comes from all sides.
_LIGHT, _AMBIENT = np.array([0.4, 0.25, 0.88]), 0.45
_TILE_M = 0.5
_DARK_TILE = 0.88


class Picture(NamedTuple):
    """Images of one moment."""

    color: NDArray[np.uint8]  #: rows, columns, and red, green and blue
    depth: NDArray[np.float32]  #: metres along the direction of view; infinity is nothing


class CameraSensor:
    """Camera of one robot. It looks along the x axis of its link, and does not see the robot.

    Args:
        spec: What its description says.
        robot: The robot that carries it.
        number: The number of the sensor, which makes its noise different from others.
    """

    def __init__(self, spec: Camera, robot: Robot, number: int) -> None:
        self.spec, self._robot, self._number = spec, robot, number
        columns = np.arange(spec.width) - (spec.width - 1) / 2
        rows = np.arange(spec.height) - (spec.height - 1) / 2
        across, down = np.meshgrid(columns / self.focal_length, rows / self.focal_length)
        rays = np.stack([np.ones_like(across), -across, -down], axis=-1).reshape(-1, 3)
        self._lengths = np.linalg.norm(rays, axis=1)
        self._rays = np.asarray(rays / self._lengths[:, None], float)

    @property
    def focal_length(self) -> float:
        """The focal length, in pixels."""
        return self.spec.width / (2 * math.tan(self.spec.field_of_view / 2))

    def measure(self, world: World) -> Picture:
        """Take a picture."""
        spec = self.spec
        origin, rays, distances, hits, normals = cast(world, self._robot, spec.link, self._rays)
        depth = distances / self._lengths
        if spec.noise:
            depth += world.noise(self._robot, self._number).normal(0.0, spec.noise, len(depth))
        is_seen = (hits >= 0) & (depth <= spec.farthest) & (depth >= spec.nearest)
        color = np.full((len(rays), 3), _SKY)
        seen = hits >= 0
        points = origin + rays[seen] * distances[seen, None]
        color[seen] = _colors(world, hits[seen], normals[seen], points)
        shape = (spec.height, spec.width)
        return Picture(
            color.astype(np.uint8).reshape(*shape, 3),
            np.where(is_seen, depth, np.inf).astype(np.float32).reshape(shape),
        )

    def points(self, picture: Picture) -> NDArray[np.float32]:
        """Return the points of a picture: x, y and z in metres for each pixel, NaN for nothing."""
        ahead = np.where(np.isfinite(picture.depth), picture.depth, np.nan)[..., None]
        rays = (self._rays * self._lengths[:, None]).reshape(*picture.depth.shape, 3)
        if self.spec.has_optical_points:
            rays = np.stack([-rays[..., 1], -rays[..., 2], rays[..., 0]], axis=-1)
        found: NDArray[np.float32] = (ahead * rays).astype(np.float32)
        return found


def _colors(
    world: World,
    hits: NDArray[np.int32],
    normals: NDArray[np.float64],
    points: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return the colours of points: brighter towards the light, and tiles on the floor."""
    light = _AMBIENT + (1 - _AMBIENT) * np.clip(normals @ _LIGHT, 0.0, 1.0)
    on_floor = world.model.geom_type[hits] == 0
    tiles = np.floor(points[:, :2] / _TILE_M).sum(axis=1) % 2
    light = np.where(on_floor & (tiles == 0), light * _DARK_TILE, light)
    found: NDArray[np.float64] = world.model.geom_rgba[hits, :3] * 255 * light[:, None]
    return found
