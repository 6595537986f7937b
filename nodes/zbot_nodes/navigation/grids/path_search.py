"""Search of the cheapest path through a grid of costs, by the algorithm A*."""

from __future__ import annotations

import heapq
import math
from typing import TYPE_CHECKING

import numpy as np

from zbot_nodes.navigation.grids.costs import NO_INFORMATION, TOUCHING

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Cell = tuple[int, int]

_DIAGONAL = math.sqrt(2)
#: A cell beside an obstacle costs so many times the cell far away from all obstacles, and one more.
_DETOUR = 4.0
_ESCAPE = 20.0


def find_path(
    costs: NDArray[np.uint8],
    start: Cell,
    goal: Cell,
    *,
    allow_unknown: bool = True,
    tolerance: float = 0.0,
) -> list[Cell] | None:
    """Return the cells of the cheapest path, or None if there is no path.

    Args:
        costs: What each cell costs. Cells of 253 and 254 are not entered. If the start is one,
            cells of 253 are entered, too, but cost much.
        start: Row and column where the path begins.
        goal: Row and column where it ends.
        allow_unknown: Whether the path may lead through cells of which nothing is known.
        tolerance: If no path reaches the goal, it may end so many cells before.
    """
    width = costs.shape[1] + 2
    is_near = TOUCHING <= costs[start] < NO_INFORMATION
    prices = _prices(costs, allow_unknown=allow_unknown, allow_touching=bool(is_near))
    first = (start[0] + 1) * width + start[1] + 1
    last = (goal[0] + 1) * width + goal[1] + 1
    parents = _search(prices, width, first, last)
    end = last if last in parents else _nearest(parents, width, last, tolerance)
    if end is None:
        return None
    cells = []
    while True:
        cells.append((end // width - 1, end % width - 1))
        if end == first:
            return cells[::-1]
        end = parents[end]


def _prices(costs: NDArray[np.uint8], *, allow_unknown: bool, allow_touching: bool) -> list[float]:
    """Return the price of one step into each cell. It is 0 for a cell that is not entered.

    A border of such cells is around the grid, so the search needs no look at its edges.
    """
    prices = 1 + costs.astype(np.float32) * np.float32(_DETOUR / TOUCHING)
    # A robot that is too near to an obstacle at the start must be able to get away.
    prices[costs >= TOUCHING] = 0
    prices[costs == TOUCHING] = _ESCAPE if allow_touching else 0
    prices[costs == NO_INFORMATION] = 1 + _DETOUR / 4 if allow_unknown else 0
    padded: list[float] = np.pad(prices, 1).ravel().tolist()
    return padded


def _search(prices: list[float], width: int, first: int, last: int) -> dict[int, int]:
    """Return for each cell that was reached the cell before it."""
    steps = [(-1, 1.0), (1, 1.0), (-width, 1.0), (width, 1.0)]
    steps += [(up + side, _DIAGONAL) for up in (-width, width) for side in (-1, 1)]
    goal_row, goal_column = divmod(last, width)
    parents, spent = {first: first}, {first: 0.0}
    done: set[int] = set()
    waiting = [(0.0, first)]
    while waiting:
        _, cell = heapq.heappop(waiting)
        if cell == last:
            break
        if cell in done:
            continue
        done.add(cell)
        so_far = spent[cell]
        for step, length in steps:
            neighbour = cell + step
            price = prices[neighbour]
            if not price:
                continue
            total = so_far + price * length
            if total < spent.get(neighbour, math.inf):
                spent[neighbour], parents[neighbour] = total, cell
                rows = abs(neighbour // width - goal_row)
                columns = abs(neighbour % width - goal_column)
                least = max(rows, columns) + (_DIAGONAL - 1) * min(rows, columns)
                heapq.heappush(waiting, (total + least, neighbour))
    return parents


def _nearest(parents: dict[int, int], width: int, last: int, tolerance: float) -> int | None:
    """Return the reached cell that is nearest to the goal, if it is near enough."""
    row, column = divmod(last, width)

    def away(cell: int) -> float:
        return math.hypot(cell // width - row, cell % width - column)

    best = min(parents, key=away)
    return best if tolerance and away(best) <= tolerance else None
