"""Geometry of a grid: where its square cells lie."""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from nav_msgs.msg import OccupancyGrid

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Integers = NDArray[np.int64]

#: Value of a cell in a map of which nothing is known.
UNKNOWN = -1


@dataclass(frozen=True)
class GridGeometry:
    """Place of a grid's cells, which are in rows from the lower left corner. Lengths in metres."""

    x: float  #: of the lower left corner
    y: float  #: of the lower left corner
    resolution: float  #: the length of a cell's side
    height: int  #: the number of rows
    width: int  #: the number of columns

    @property
    def shape(self) -> tuple[int, int]:
        """The numbers of rows and columns."""
        return self.height, self.width

    def cells(self, points: Floats) -> tuple[Integers, Integers]:
        """Return the rows and the columns of points. They may be outside of the grid."""
        columns = np.floor((points[..., 0] - self.x) / self.resolution).astype(np.int64)
        rows = np.floor((points[..., 1] - self.y) / self.resolution).astype(np.int64)
        return rows, columns

    def contains(self, rows: Integers, columns: Integers) -> NDArray[np.bool_]:
        """Return which cells are in the grid."""
        return (rows >= 0) & (rows < self.height) & (columns >= 0) & (columns < self.width)

    def cell(self, x: float, y: float) -> tuple[int, int] | None:
        """Return the row and the column of a point, or None if it is outside of the grid."""
        rows, columns = self.cells(np.array([[x, y]]))
        inside = bool(self.contains(rows, columns)[0])
        return (int(rows[0]), int(columns[0])) if inside else None

    def centres(self, rows: Integers, columns: Integers) -> Floats:
        """Return the points in the middle of cells, one in a row."""
        x = self.x + (columns + 0.5) * self.resolution
        y = self.y + (rows + 0.5) * self.resolution
        return np.stack([x, y], axis=-1).astype(np.float64)

    def moved(self, rows: int, columns: int) -> GridGeometry:
        """Return the geometry after a move by whole cells."""
        cell = self.resolution
        return replace(self, x=self.x + columns * cell, y=self.y + rows * cell)


def geometry_of(info: Any) -> GridGeometry:
    """Return the geometry in the `info` of an OccupancyGrid. A turned origin counts as straight."""
    origin = info.origin.position
    return GridGeometry(origin.x, origin.y, info.resolution, info.height, info.width)


def is_whole(message: Any) -> bool:
    """Return whether an OccupancyGrid has as many cells as it says, and cells of some size."""
    info = message.info
    has_all = 0 < len(message.data) == info.width * info.height
    return has_all and bool(0 < info.resolution < math.inf)


def cells_of(message: Any) -> NDArray[np.int8]:
    """Return the cells of an OccupancyGrid as rows and columns."""
    shape = (message.info.height, message.info.width)
    return np.array(memoryview(message.data), np.int8).reshape(shape)


def grid_message(cells: NDArray[Any], geometry: GridGeometry, frame: str, stamp: Any) -> Any:
    """Return cells as an OccupancyGrid."""
    message = OccupancyGrid()
    message.header.frame_id, message.header.stamp = frame, stamp
    info = message.info
    info.map_load_time, info.resolution = stamp, geometry.resolution
    info.height, info.width = geometry.shape
    info.origin.position.x, info.origin.position.y = geometry.x, geometry.y
    message.data = array("b", cells.astype(np.int8).tobytes())
    return message
