"""Rays from the camera through the place of a click, and what they meet."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.tf2.rigid import Rigid, Vector
    from zbot.view.shape import Floats

_FARTHEST_M = 10_000.0
_FLAT = 1e-9


class Ray(NamedTuple):
    """Ray from a point. The direction has the length 1."""

    origin: Vector
    direction: Vector

    def seen_from(self, pose: Rigid) -> Ray:
        """Return the ray in the coordinates of a pose."""
        back = pose.inverse()
        start, end = back.apply(self.origin), back.apply(self.at(1.0))
        x, y, z = (far - near for far, near in zip(end, start, strict=True))
        return Ray(start, (x, y, z))

    def at(self, distance: float) -> Vector:
        """Return the point at a distance."""
        x, y, z = (
            start + distance * part for start, part in zip(self.origin, self.direction, strict=True)
        )
        return x, y, z


def floor_point(ray: Ray) -> Vector | None:
    """Return where a ray meets the plane of x and y, or None if it does not meet it."""
    height, slope = ray.origin[2], ray.direction[2]
    if abs(slope) < _FLAT or not 0 < -height / slope < _FARTHEST_M:
        return None
    x, y, _ = ray.at(-height / slope)
    return x, y, 0.0


def distance_to_points(ray: Ray, points: NDArray[Any], width: float) -> float | None:
    """Return the distance to the nearest point in a thin cone around a ray, or None.

    Args:
        ray: The ray.
        points: The points, of the shape (n, 3).
        width: The radius of the cone, as a share of the distance.
    """
    along, aside = _split(ray, points)
    hits = along[(along > 0) & (aside <= along * width)]
    return float(np.min(hits)) if hits.size else None


def distance_to_lines(ray: Ray, ends: Floats, width: float) -> float | None:
    """Return the distance to the nearest of some lines, or None. Each line gets 32 points."""
    shares = np.linspace(0, 1, 32, dtype=np.float32)[:, None, None]
    points = ends[None, :, 0] * (1 - shares) + ends[None, :, 1] * shares
    return distance_to_points(ray, points.reshape(-1, 3), width)


def distance_to_surface(ray: Ray, vertices: Floats, faces: NDArray[np.uint32]) -> float | None:
    """Return the distance to the nearest triangle that a ray meets, or None."""
    corners = vertices.astype(np.float64)[faces]
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    direction = np.array(ray.direction)
    across = np.cross(direction, two)
    size = (one * across).sum(axis=1)
    is_met = np.abs(size) > _FLAT * _FLAT
    size = np.where(is_met, size, 1.0)
    start = np.array(ray.origin) - corners[:, 0]
    first = (start * across).sum(axis=1) / size
    turned = np.cross(start, one)
    second = (turned @ direction) / size
    distance = (two * turned).sum(axis=1) / size
    is_met &= (first >= 0) & (second >= 0) & (first + second <= 1) & (distance > 0)
    return float(np.min(distance[is_met])) if is_met.any() else None


def _split(ray: Ray, points: NDArray[Any]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return how far points are along a ray, and how far they are beside it."""
    from_origin = points.astype(np.float64) - np.array(ray.origin)
    along = from_origin @ np.array(ray.direction)
    beside = from_origin - along[:, None] * np.array(ray.direction)
    return along, np.linalg.norm(beside, axis=1)
