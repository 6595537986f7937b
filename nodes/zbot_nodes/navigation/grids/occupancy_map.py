"""Map that grows with each scan: for each cell, the logarithm of the odds that it is occupied."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from zbot_nodes.navigation.grids.geometry import UNKNOWN, GridGeometry
from zbot_nodes.navigation.grids.rays import crossed, marked

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from zbot_nodes.navigation.grids.rays import Rays

_HIT, _MISS = 0.9, -0.4  # what one ray adds
_MOST, _LEAST = 4.0, -2.5
_MARGIN_M = 2.0
_MOST_CELLS = 16_000_000


class OccupancyMap:
    """Map of what scans have seen.

    Attributes:
        geometry: Where the cells are.
        odds: The logarithms of the odds. Zero means that nothing is known.
    """

    def __init__(self, resolution: float) -> None:
        self.geometry = GridGeometry(0.0, 0.0, resolution, 0, 0)
        self.odds = np.zeros((0, 0), np.float32)

    def add(self, rays: Rays) -> None:
        """Add a scan. Its rays are in the frame of the map."""
        self._grow(rays)
        self.odds[crossed(rays, self.geometry)] += np.float32(_MISS)
        self.odds[marked(rays.hits, self.geometry)] += np.float32(_HIT)
        np.clip(self.odds, _LEAST, _MOST, out=self.odds)

    @property
    def occupied(self) -> NDArray[np.bool_]:
        """The cells that are rather occupied than free."""
        return self.odds > 0

    def cells(self) -> NDArray[np.int8]:
        """Return the map as in OccupancyGrid: 0 is free, 100 is occupied, -1 is unknown."""
        values = np.where(self.odds > 0, 100, 0).astype(np.int8)
        values[self.odds == 0] = UNKNOWN
        return values

    def _grow(self, rays: Rays) -> None:
        """Make the map large enough for a scan."""
        points = np.vstack([rays.origin, rays.ends])
        rows, columns = self.geometry.cells(points)
        if self.odds.size and self.geometry.contains(rows, columns).all():
            return
        cell = self.geometry.resolution
        margin = math.ceil(_MARGIN_M / cell)
        low = np.minimum(0, np.array([np.min(rows), np.min(columns)]) - margin)
        ends = np.array([np.max(rows), np.max(columns)]) + margin + 1
        high = np.maximum(self.geometry.shape, ends)
        height, width = (int(size) for size in high - low)
        if height * width > _MOST_CELLS:
            return  # what is outside of the map is left out
        larger = np.zeros((height, width), np.float32)
        row, column = (int(start) for start in -low)
        larger[row : row + self.odds.shape[0], column : column + self.odds.shape[1]] = self.odds
        self.odds = larger
        self.geometry = replace(self.geometry.moved(-row, -column), height=height, width=width)
