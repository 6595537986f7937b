"""Path as points in a plane: how long it is, and how to take its corners off."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from zbot_nodes.navigation.grids.costs import NO_INFORMATION, TOUCHING

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.grids.geometry import GridGeometry

    Floats = NDArray[np.float64]

_ROUNDS = 60
_TO_NEIGHBOURS, _TO_ORIGINAL = 0.4, 0.02


def length(points: Floats) -> float:
    """Return the length of a path in metres."""
    return float(np.hypot(*np.diff(points, axis=0).T).sum()) if len(points) > 1 else 0.0


def headings(points: Floats) -> Floats:
    """Return the direction from each point to the next one. The last point has that before it."""
    if len(points) < 2:
        return np.zeros(len(points))
    ways = np.diff(points, axis=0)
    angles = np.arctan2(ways[:, 1], ways[:, 0])
    found: Floats = np.append(angles, angles[-1:])
    return found


def nearest(points: Floats, x: float, y: float) -> int:
    """Return the number of the point that is nearest to a place."""
    return int(np.argmin(np.hypot(points[:, 0] - x, points[:, 1] - y)))


def smooth(points: Floats, costs: NDArray[np.uint8], geometry: GridGeometry) -> Floats:
    """Return a path with the same ends and without corners.

    Each point moves a little to the middle of its neighbours, many times. Where this would lead
    into a cell that costs more and is close to an obstacle, the path stays as it was.
    """
    limit = np.maximum(cost_at(points, costs, geometry), TOUCHING // 2)
    best = points.copy()
    for _ in range(_ROUNDS):
        middle = best[1:-1]
        to_neighbours = (best[:-2] + best[2:]) / 2 - middle
        to_original = points[1:-1] - middle
        tried = middle + _TO_NEIGHBOURS * to_neighbours + _TO_ORIGINAL * to_original
        allowed = cost_at(tried, costs, geometry) <= limit[1:-1]
        best[1:-1][allowed] = tried[allowed]
    found: Floats = best
    return found


def cost_at(points: Floats, costs: NDArray[np.uint8], geometry: GridGeometry) -> NDArray[np.int64]:
    """Return the costs at points. What is unknown or outside of the grid costs nothing."""
    rows, columns = geometry.cells(points)
    inside = geometry.contains(rows, columns)
    found = np.zeros(len(points), np.int64)
    found[inside] = costs[rows[inside], columns[inside]]
    found[found == NO_INFORMATION] = 0
    return found
