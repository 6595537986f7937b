"""Match of a scan with a map: the pose at which the points of a scan lie on the map's walls."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from zbot_nodes.navigation.grids.distances import distances
from zbot_nodes.navigation.grids.rays import moved
from zbot_nodes.robot.pose import Pose, turn_to

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.grids.geometry import GridGeometry

    Floats = NDArray[np.float64]

_REACH_M = 0.5
_COARSE_POINTS = 90
_MOST_STEPS = 12
_SOLID_M = 0.1  # points that are farther from all walls count less
#: How much a pose may differ from the odometry, beside what one point says.
_ODOMETRY_WEIGHTS = np.diag([2.0, 2.0, 2.0])


class Match(NamedTuple):
    """Found pose."""

    pose: Pose
    error_m: float  #: the mean distance of the points from the nearest walls, at most 0.5


class ScanMatcher:
    """Matcher for one map.

    Args:
        occupied: The occupied cells of the map.
        geometry: Where the cells are.
    """

    def __init__(self, occupied: NDArray[np.bool_], geometry: GridGeometry) -> None:
        cell = geometry.resolution
        reach = max(2, math.ceil(_REACH_M / cell))
        # With a border, points that are outside of the map are at the greatest distance.
        away = distances(occupied, reach).astype(np.float64)
        self._field = np.pad(away, 1, constant_values=reach) * cell
        self._geometry, self._reach_m = geometry, reach * cell

    def match(
        self, points: Floats, guess: Pose, *, window_m: float = 0.2, window_rad: float = 0.2
    ) -> Match:
        """Return the pose of a robot.

        Args:
            points: What its lidar sees, in the robot's frame.
            guess: About where the robot is.
            window_m: How far x and y may be from the guess.
            window_rad: How far the heading may be from the guess.
        """
        if not len(points):
            return Match(guess, self._reach_m)
        start = self._search(points, guess, window_m, window_rad)
        found = self._refine(points, start)
        return (
            found
            if found.error_m <= self._error(points, start)
            else Match(start, self._error(points, start))
        )

    def _search(self, points: Floats, guess: Pose, window_m: float, window_rad: float) -> Pose:
        """Try all poses of a coarse grid around the guess."""
        few = points[:: max(1, len(points) // _COARSE_POINTS)]
        steps = np.arange(-4, 5) / 4
        shifts = np.array([[x, y] for x in steps * window_m for y in steps * window_m])
        best, best_score = guess, math.inf
        for turn in steps * window_rad:
            turned = moved(few, Pose(guess.x, guess.y, guess.yaw + turn))
            values = self._at(turned[None] + shifts[:, None]).mean(axis=1)
            # Of poses that fit equally well, the nearest to the guess is the best.
            values = values + 0.02 * np.hypot(*shifts.T) + 0.02 * abs(turn)
            number = int(values.argmin())
            if values[number] < best_score:
                best_score = float(values[number])
                x, y = shifts[number]
                best = Pose(guess.x + x, guess.y + y, guess.yaw + turn)
        return best

    def _refine(self, points: Floats, start: Pose) -> Match:
        """Move the pose downhill by steps of Gauss and Newton."""
        pose = np.array(start)
        for _ in range(_MOST_STEPS):
            here = moved(points, Pose(*pose))
            value, slope_x, slope_y = self._slopes(here)
            arm = here - pose[:2]
            turn = slope_y * arm[:, 0] - slope_x * arm[:, 1]
            jacobian = np.stack([slope_x, slope_y, turn], axis=1)
            weights = 1 / (1 + (value / _SOLID_M) ** 2)
            weighted = jacobian * weights[:, None]
            pull = _ODOMETRY_WEIGHTS @ (pose - np.array(start))
            matrix = weighted.T @ jacobian + _ODOMETRY_WEIGHTS
            step = np.linalg.solve(matrix, weighted.T @ value + pull)
            pose = pose - step
            if np.abs(step).max() < 1e-4:
                break
        found = Pose(float(pose[0]), float(pose[1]), turn_to(float(pose[2])))
        return Match(found, self._error(points, found))

    def _error(self, points: Floats, pose: Pose) -> float:
        return float(self._slopes(moved(points, pose))[0].mean())

    def _at(self, points: Floats) -> Floats:
        """Return the distances from the walls, without interpolation."""
        rows, columns = self._geometry.cells(points)
        height, width = self._geometry.shape
        found: Floats = self._field[np.clip(rows, -1, height) + 1, np.clip(columns, -1, width) + 1]
        return found

    def _slopes(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Return the distances between the middles of cells, and their slopes along x and y."""
        geometry, cell = self._geometry, self._geometry.resolution
        column = np.clip((points[:, 0] - geometry.x) / cell + 0.5, 0, geometry.width + 0.999)
        row = np.clip((points[:, 1] - geometry.y) / cell + 0.5, 0, geometry.height + 0.999)
        left, low = column.astype(np.int64), row.astype(np.int64)
        right, up = column - left, row - low
        field = self._field
        a, b = field[low, left], field[low, left + 1]
        c, d = field[low + 1, left], field[low + 1, left + 1]
        value = (a * (1 - right) + b * right) * (1 - up) + (c * (1 - right) + d * right) * up
        slope_x = ((b - a) * (1 - up) + (d - c) * up) / cell
        slope_y = ((c - a) * (1 - right) + (d - b) * right) / cell
        return value, slope_x, slope_y
