"""Room with a box in it, as a grid and as a lidar sees it, for tests of maps."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from zbot_nodes.navigation.grids.geometry import GridGeometry
from zbot_nodes.navigation.grids.rays import Rays

if TYPE_CHECKING:
    from zbot_nodes.robot.pose import Pose

GEOMETRY = GridGeometry(-3.0, -2.0, 0.05, 80, 120)
#: Walls as lines: x and y of both ends.
WALLS = np.array(
    [
        *((-2.5, -1.5, 2.5, -1.5), (2.5, -1.5, 2.5, 1.5), (2.5, 1.5, -2.5, 1.5)),
        *((-2.5, 1.5, -2.5, -1.5), (-1.0, 1.5, -1.0, 0.6), (1.2, -1.5, 2.5, -0.2)),
        *((0.5, 0.2, 1.1, 0.2), (1.1, 0.2, 1.1, 1.0), (1.1, 1.0, 0.5, 1.0), (0.5, 1.0, 0.5, 0.2)),
    ]
)
_RAYS = 180


def occupied() -> np.ndarray:
    """Return the grid of the room."""
    cells = np.zeros(GEOMETRY.shape, bool)
    for x1, y1, x2, y2 in WALLS:
        shares = np.linspace(0, 1, 400)[:, None]
        points = np.array([x1, y1]) + shares * np.array([x2 - x1, y2 - y1])
        rows, columns = GEOMETRY.cells(points)
        cells[rows, columns] = True
    return cells


def look(pose: Pose, *, noise: float = 0.01, seed: int = 0) -> Rays:
    """Return what a lidar sees at a pose, in the frame of the robot."""
    angles = np.arange(_RAYS) * (2 * math.pi / _RAYS)
    directions = np.stack([np.cos(angles + pose.yaw), np.sin(angles + pose.yaw)], axis=1)
    start, side = WALLS[:, :2] - pose[:2], WALLS[:, 2:] - WALLS[:, :2]
    cross = directions[:, :1] * side[:, 1] - directions[:, 1:] * side[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        along = (start[:, 0] * side[:, 1] - start[:, 1] * side[:, 0]) / cross
        share = (start[:, 0] * directions[:, 1:] - start[:, 1] * directions[:, :1]) / cross
    along[~((along > 0) & (share >= 0) & (share <= 1))] = math.inf
    ranges = along.min(axis=1) + np.random.default_rng(seed).normal(0, noise, _RAYS)
    ends = ranges[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return Rays(np.zeros(2), ends, np.isfinite(ranges))
