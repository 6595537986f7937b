"""Rays of a scan in a grid: the cells that they cross, and their ends as points."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot.tf2.rigid import Rigid
    from zbot_nodes.navigation.grids.geometry import GridGeometry
    from zbot_nodes.robot.pose import Pose

    Floats = NDArray[np.float64]


_FARTHEST_M = 100.0


class Rays(NamedTuple):
    """Rays of one scan. All points have the same frame."""

    origin: Floats  #: where the rays begin: x and y in metres
    ends: Floats  #: where they end, one in a row
    is_hit: NDArray[np.bool_]  #: whether something is at the end

    @property
    def hits(self) -> Floats:
        """The points of obstacles."""
        return self.ends[self.is_hit]

    def seen_from(self, pose: Pose) -> Rays:
        """Return the rays in the frame in which their frame has a pose."""
        ends = moved(np.vstack([self.origin, self.ends]), pose)
        return Rays(ends[0], ends[1:], self.is_hit)

    def up_to(self, farthest: float) -> Rays:
        """Return the rays, cut at a distance. What is farther away is no hit."""
        ways = self.ends - self.origin
        lengths = np.maximum(np.hypot(ways[:, 0], ways[:, 1]), 1e-9)
        shares = np.minimum(1.0, farthest / lengths)
        ends = self.origin + ways * shares[:, None]
        return Rays(self.origin, ends, self.is_hit & (lengths <= farthest))

    def thinned(self, most: int) -> Rays:
        """Return at most so many rays, evenly spread."""
        step = max(1, math.ceil(len(self.ends) / most))
        return Rays(self.origin, self.ends[::step], self.is_hit[::step])


def moved(points: Floats, pose: Pose) -> Floats:
    """Return points of a frame in the frame in which it has a pose."""
    cos, sin = math.cos(pose.yaw), math.sin(pose.yaw)
    turn = np.array([[cos, sin], [-sin, cos]])
    found: Floats = points @ turn + np.array([pose.x, pose.y])
    return found


def rays_of(scan: Any, lidar: Rigid) -> Rays:
    """Return the rays of a LaserScan in the frame in which the lidar has a pose.

    As in REP 117, infinity means that nothing is in reach. Other values that are not in the
    range of the lidar say nothing, and their rays are left out.

    Args:
        scan: The message.
        lidar: The pose of the lidar. It may hang upside down.
    """
    ranges = np.array(scan.ranges, np.float64)
    angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
    is_free = (ranges == math.inf) | (ranges > scan.range_max)
    is_hit = (ranges >= scan.range_min) & ~is_free  # false for NaN, too
    ranges[is_free] = min(scan.range_max, _FARTHEST_M)
    kept = (is_hit | is_free) & np.isfinite(angles)
    ranges, angles, is_hit = ranges[kept], angles[kept], is_hit[kept]
    points = np.stack([ranges * np.cos(angles), ranges * np.sin(angles)], axis=1)
    x_axis, y_axis = (
        np.subtract(lidar.apply(axis), lidar.translation)[:2]
        for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    )
    origin = np.array(lidar.translation[:2])
    return Rays(origin, points @ np.stack([x_axis, y_axis]) + origin, is_hit)


def crossed(rays: Rays, geometry: GridGeometry) -> NDArray[np.bool_]:
    """Return the cells of a grid that rays cross. The cells of their ends do not count."""
    step = geometry.resolution
    ways = rays.ends - rays.origin
    lengths = np.hypot(ways[:, 0], ways[:, 1])
    along = np.arange(0.0, lengths.max(initial=0.0), step)
    directions = ways / np.maximum(lengths, 1e-9)[:, None]
    # A point is only looked at if it is before the cell of the end.
    ray, number = np.nonzero(along[None, :] < (lengths - step / 2)[:, None])
    points = rays.origin + directions[ray] * along[number, None]
    cells = marked(points, geometry)
    cells &= ~marked(rays.hits, geometry)
    return cells


def marked(points: Floats, geometry: GridGeometry) -> NDArray[np.bool_]:
    """Return the cells of a grid that contain points."""
    cells = np.zeros(geometry.shape, bool)
    rows, columns = geometry.cells(points)
    inside = geometry.contains(rows, columns)
    cells[rows[inside], columns[inside]] = True
    return cells
