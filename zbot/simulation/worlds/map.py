"""Worlds from maps: each occupied cell of a map in YAML and an image becomes a part of a wall."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.navigation.map_file import MapFileError, read_map
from zbot.simulation.engine import new_spec
from zbot.simulation.errors import SimulationError
from zbot.simulation.worlds.plan import WALL, WALL_HEIGHT_M, Place, Thing, add_floor, add_things

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from numpy.typing import NDArray

_OCCUPIED = 65
_MOST_CELLS = 4_000_000
_MOST_BOXES = 4000


def map_spec(path: Path) -> Any:
    """Return the world of a map.

    Raises:
        SimulationError: The map cannot be read, or is too large.
    """
    try:
        grid = read_map(str(path))
    except MapFileError as error:
        raise SimulationError(str(error)) from error
    info = grid.info
    if info.width * info.height > _MOST_CELLS:
        raise SimulationError(f"the map has {info.width * info.height} cells: the limit is 4000000")
    cells = np.array(grid.data, np.int8).reshape(info.height, info.width) >= _OCCUPIED
    boxes = list(rectangles(cells))
    if len(boxes) > _MOST_BOXES:
        raise SimulationError(f"the map needs {len(boxes)} boxes: the limit is {_MOST_BOXES}")
    spec = new_spec()
    add_floor(spec)
    add_things(spec, (_thing(box, info) for box in boxes))
    return spec


def rectangles(cells: NDArray[np.bool_]) -> Iterator[tuple[int, int, int, int]]:
    """Return rectangles that cover all true cells: first row and column, and the ends after them.

    A run of cells in a row grows upwards as long as the rows above have the same run.
    """
    growing: dict[tuple[int, int], int] = {}  # the first row of each run of the row before
    for row in range(len(cells) + 1):
        runs = _runs(cells[row]) if row < len(cells) else set()
        for (start, end), first in list(growing.items()):
            if (start, end) not in runs:
                yield first, start, row, end
                del growing[start, end]
        for run in runs:
            growing.setdefault(run, row)


def _runs(row: NDArray[np.bool_]) -> set[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], row, [False]]).astype(np.int8)))
    return {(int(start), int(end)) for start, end in edges.reshape(-1, 2)}


def _thing(box: tuple[int, int, int, int], info: Any) -> Thing:
    first_row, first_column, last_row, last_column = box
    cell = info.resolution
    x = (first_column + last_column) / 2 * cell
    y = (first_row + last_row) / 2 * cell
    origin = info.origin
    yaw = 2 * math.atan2(origin.orientation.z, origin.orientation.w)
    place = Place(
        origin.position.x + x * math.cos(yaw) - y * math.sin(yaw),
        origin.position.y + x * math.sin(yaw) + y * math.cos(yaw),
        yaw,
    )
    size = ((last_column - first_column) * cell, (last_row - first_row) * cell, WALL_HEIGHT_M)
    return Thing("box", place, size, WALL)
