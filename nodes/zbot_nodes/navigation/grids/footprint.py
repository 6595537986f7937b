"""Outline of a robot on the floor, and whether it touches an obstacle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from zbot.text.json_reader import read_json
from zbot_nodes.navigation.grids.costs import NO_INFORMATION, OBSTACLE, TOUCHING
from zbot_nodes.navigation.grids.distances import distances
from zbot_nodes.navigation.grids.rays import moved

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.grids.geometry import GridGeometry
    from zbot_nodes.robot.pose import Pose

    Floats = NDArray[np.float64]

_CORNERS_OF_CIRCLE = 16
_LEAST_CORNERS = 3
_NEAR_M = 1.0


class Footprint:
    """Outline of a robot.

    Attributes:
        corners: Its corners in the robot's frame, one in a row.
        inscribed_m: The radius of the largest circle in it, around the robot's frame.
        circumscribed_m: The radius of the smallest circle around it.
    """

    def __init__(self, corners: Floats, *, radius_m: float | None = None) -> None:
        self.corners, self.is_circle = corners, radius_m is not None
        after = np.roll(corners, -1, axis=0)
        sides = after - corners
        across = np.abs(sides[:, 0] * corners[:, 1] - sides[:, 1] * corners[:, 0])
        apart = across / np.maximum(np.hypot(*sides.T), 1e-9)
        self.inscribed_m = float(apart.min()) if radius_m is None else radius_m
        self.circumscribed_m = float(np.hypot(*corners.T).max())

    @classmethod
    def circle(cls, radius_m: float) -> Footprint:
        """Return the outline of a round robot."""
        angles = np.arange(_CORNERS_OF_CIRCLE) * (2 * math.pi / _CORNERS_OF_CIRCLE)
        corners = radius_m * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return cls(corners, radius_m=radius_m)

    def touches(
        self, poses: list[Pose], costs: NDArray[np.uint8], geometry: GridGeometry
    ) -> int | None:
        """Return the number of the first pose at which the robot touches an obstacle, or None."""
        for number, pose in enumerate(poses):
            cell = geometry.cell(pose.x, pose.y)
            cost = 0 if cell is None else int(costs[cell])
            if TOUCHING <= cost < NO_INFORMATION:
                return number
            if not self.is_circle and cost and self._outline_touches(pose, costs, geometry):
                return number
        return None

    def _outline_touches(
        self, pose: Pose, costs: NDArray[np.uint8], geometry: GridGeometry
    ) -> bool:
        after = np.roll(self.corners, -1, axis=0)
        longest = np.hypot(*(after - self.corners).T).max()
        shares = np.linspace(0, 1, max(2, math.ceil(longest / geometry.resolution)))
        line = self.corners[None] + (after - self.corners)[None] * shares[:, None, None]
        rows, columns = geometry.cells(moved(line.reshape(-1, 2), pose))
        inside = geometry.contains(rows, columns)
        return bool((costs[rows[inside], columns[inside]] == OBSTACLE).any())


def leads_away(
    start: Pose, end: Pose, obstacles: NDArray[np.bool_], geometry: GridGeometry
) -> bool:
    """Return whether a robot is farther from all obstacles at the end than at the start.

    A robot that is too near to an obstacle already may move in this way.
    """
    away = distances(obstacles, round(_NEAR_M / geometry.resolution))
    first, last = geometry.cell(start.x, start.y), geometry.cell(end.x, end.y)
    return first is not None and last is not None and bool(away[last] > away[first])


def footprint_of(text: str, radius_m: float, padding_m: float = 0.0) -> Footprint:
    """Return the outline of the parameters `footprint` and `robot_radius`.

    Raises:
        ValueError: The text is not a list of at least three points.
    """
    if not text.strip() or text.strip() == "[]":
        return Footprint.circle(radius_m + padding_m)
    corners = corners_of(text)
    return Footprint(corners + np.sign(corners) * padding_m)


def corners_of(text: str) -> Floats:
    """Return the corners of an outline in JSON, e.g. `[[0.1, 0.1], [0.1, -0.1], [-0.1, 0.0]]`.

    Raises:
        ValueError: The text is not a list of at least three points.
    """
    try:
        corners = np.array(read_json(text), np.float64)
    except (TypeError, ValueError, OverflowError):
        corners = np.zeros(0)
    is_list = corners.ndim == 2 and corners.shape[1:] == (2,) and len(corners) >= _LEAST_CORNERS
    if not is_list or not np.isfinite(corners).all():
        raise ValueError(f"{text[:60]!r} is not a list of at least three points [x, y]")
    return corners
