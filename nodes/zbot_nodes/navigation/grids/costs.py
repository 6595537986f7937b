"""Costs of a grid: what it costs a robot to be with its middle in each cell.

The costs are those of ROS 2: 0 is free, 1 to 252 are near obstacles, 253 touches one, 254 is one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from zbot_nodes.navigation.grids.distances import distances
from zbot_nodes.navigation.grids.rays import crossed, marked

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.grids.geometry import GridGeometry
    from zbot_nodes.navigation.grids.rays import Rays

    Costs = NDArray[np.uint8]

FREE, TOUCHING, OBSTACLE, NO_INFORMATION = 0, 253, 254, 255


@dataclass(frozen=True)
class Inflation:
    """How the costs around an obstacle fall."""

    inscribed_m: float  #: the radius of the robot, or of the largest circle in its outline
    radius_m: float = 0.55  #: cells that are farther away from obstacles are free
    steepness: float = 3.0  #: how fast the costs fall, per metre

    def costs(self, occupied: NDArray[np.bool_], resolution: float) -> Costs:
        """Return the costs around occupied cells."""
        away = distances(occupied, max(1, math.ceil(self.radius_m / resolution))) * resolution
        falling = np.exp(-self.steepness * (away - self.inscribed_m)) * (TOUCHING - 1)
        costs = np.where(away <= self.radius_m - 1e-6, falling.clip(0, TOUCHING - 1), FREE)
        costs[away <= self.inscribed_m] = TOUCHING
        costs[occupied] = OBSTACLE
        return costs.astype(np.uint8)


class ObstacleLayer:
    """Obstacles that scans have seen, in a grid that may move with the robot.

    Attributes:
        cells: Whether each cell has an obstacle.
        geometry: Where the cells are.
    """

    def __init__(self, geometry: GridGeometry) -> None:
        self.geometry = geometry
        self.cells = np.zeros(geometry.shape, bool)

    def add(self, rays: Rays, *, mark_m: float = 2.5, clear_m: float = 3.0) -> None:
        """Clear the cells that rays cross, and mark those at their ends.

        Args:
            rays: The rays, in the frame of the grid.
            mark_m: Obstacles that are farther away are left out.
            clear_m: Up to which distance cells are cleared.
        """
        self.cells &= ~crossed(rays.up_to(clear_m), self.geometry)
        self.cells |= marked(rays.up_to(mark_m).hits, self.geometry)

    def move_to(self, x: float, y: float) -> None:
        """Move the grid by whole cells, so that a point is in its middle."""
        geometry = self.geometry
        cell = geometry.resolution
        columns = round((x - geometry.width * cell / 2 - geometry.x) / cell)
        rows = round((y - geometry.height * cell / 2 - geometry.y) / cell)
        if not rows and not columns:
            return
        self.geometry = geometry.moved(rows, columns)
        old, self.cells = self.cells, np.zeros(geometry.shape, bool)
        if abs(rows) < geometry.height and abs(columns) < geometry.width:
            to_rows, from_rows = _overlap(rows, geometry.height)
            to_columns, from_columns = _overlap(columns, geometry.width)
            self.cells[to_rows, to_columns] = old[from_rows, from_columns]

    def clear(self, x: float, y: float, half_m: float, *, inside: bool) -> None:
        """Forget the obstacles in the square around a point, or outside of it."""
        geometry = self.geometry
        rows, columns = np.mgrid[0 : geometry.height, 0 : geometry.width]
        away = np.abs(geometry.centres(rows, columns) - (x, y)).max(axis=-1)
        self.cells[(away <= half_m) if inside else (away > half_m)] = False


def _overlap(shift: int, size: int) -> tuple[slice, slice]:
    """Return the part of the new and of the old rows that both have."""
    kept = size - abs(shift)
    return (
        (slice(0, kept), slice(shift, size))
        if shift >= 0
        else (
            slice(-shift, size),
            slice(0, kept),
        )
    )


def to_occupancy(costs: Costs) -> NDArray[np.int8]:
    """Return costs as percent, for a message OccupancyGrid."""
    percent = np.round(costs.astype(np.float32) * (98 / (TOUCHING - 1))).clip(0, 98)
    percent[(costs > FREE) & (percent < 1)] = 1
    percent[costs == TOUCHING] = 99
    percent[costs == OBSTACLE] = 100
    percent[costs == NO_INFORMATION] = -1
    return percent.astype(np.int8)
