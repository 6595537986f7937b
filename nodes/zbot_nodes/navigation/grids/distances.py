"""Distances from each cell of a grid to the nearest occupied cell."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def distances(occupied: NDArray[np.bool_], farthest: int) -> NDArray[np.float32]:
    """Return the distance of each cell to the nearest occupied cell, in cells.

    The distances in each column come first. Then each cell looks at its neighbours in the row:
    the square of a distance is that of the columns between plus that in the neighbour's column.

    Args:
        occupied: The occupied cells.
        farthest: Distances above this count as this.
    """
    limit = np.float32(farthest)
    down = np.where(occupied, np.float32(0), limit)
    up = down.copy()
    last = len(down) - 1
    for row in range(1, len(down)):
        np.minimum(down[row], down[row - 1] + 1, out=down[row])
        np.minimum(up[last - row], up[last - row + 1] + 1, out=up[last - row])
    in_column = np.minimum(down, up) ** 2
    squares = in_column.copy()
    for shift in range(1, min(farthest, occupied.shape[1] - 1) + 1):
        beside = np.float32(shift * shift)
        np.minimum(squares[:, shift:], in_column[:, :-shift] + beside, out=squares[:, shift:])
        np.minimum(squares[:, :-shift], in_column[:, shift:] + beside, out=squares[:, :-shift])
    found: NDArray[np.float32] = np.minimum(np.sqrt(squares), limit)
    return found
