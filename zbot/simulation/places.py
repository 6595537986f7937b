"""Free places for robots on the floor of a world, found by rays."""

from __future__ import annotations

import math
from collections import deque
from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.errors import SimulationError
from zbot.simulation.worlds.plan import Place

if TYPE_CHECKING:
    from zbot.simulation.world import World

_DISTANCE_M = 0.6  # between two robots
_STEP_M = 0.2
_RADIUS_M = 0.25
_HEIGHT_M = 0.1
_RAYS = 24
_MOST_TRIES = 20_000


def free_places(world: World, start: Place, count: int) -> list[Place]:
    """Return places around a start where robots stand freely and can reach each other.

    Args:
        world: A world. Robots that are in it take their places.
        start: Where to begin. If this place is not free, the nearest free place is the start.
        count: The number of places.

    Raises:
        SimulationError: The world has not enough free places.
    """
    first = next((place for place in _around(world, start) if _is_free(world, place)), None)
    found: list[Place] = []
    waiting = deque([] if first is None else [first])
    seen = {_cell(place) for place in waiting}
    while waiting and len(found) < count:
        place = waiting.popleft()
        if all(math.hypot(place.x - at.x, place.y - at.y) >= _DISTANCE_M for at in found):
            found.append(place)
        for x, y in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            beside = Place(place.x + x * _STEP_M, place.y + y * _STEP_M, start.yaw)
            if _cell(beside) not in seen and _is_open(world, place, x, y):
                seen.add(_cell(beside))
                if _is_free(world, beside):
                    waiting.append(beside)
    if len(found) < count:
        raise SimulationError(f"the world has free places for only {len(found)} robots")
    return found


def _around(world: World, start: Place) -> list[Place]:
    """Return the places of a grid on the floor, the nearest first."""
    low, high = world.bounds()
    step = max(0.2, math.sqrt(float(np.prod(high - low)) / _MOST_TRIES))
    grid = [
        Place(float(x), float(y), start.yaw)
        for x in np.arange(low[0], high[0], step)
        for y in np.arange(low[1], high[1], step)
    ]
    return [start, *sorted(grid, key=lambda at: math.hypot(at.x - start.x, at.y - start.y))]


def _cell(place: Place) -> tuple[int, int]:
    return round(place.x / _STEP_M), round(place.y / _STEP_M)


def _is_free(world: World, place: Place) -> bool:
    angles = np.arange(_RAYS) * (2 * math.pi / _RAYS)
    rays = np.stack([np.cos(angles), np.sin(angles), np.zeros(_RAYS)], axis=1)
    distances, _, _ = world.cast(np.array([place.x, place.y, _HEIGHT_M]), rays)
    if ((distances >= 0) & (distances < _RADIUS_M)).any():
        return False
    # A ray from above shows whether the place is in a solid: rays do not see it from inside.
    below, _, _ = world.cast(np.array([place.x, place.y, 10.0]), np.array([[0.0, 0.0, -1.0]]))
    return abs(float(below[0]) - 10.0) < _HEIGHT_M / 2


def _is_open(world: World, place: Place, x: int, y: int) -> bool:
    ray = np.array([[float(x), float(y), 0.0]])
    distances, _, _ = world.cast(np.array([place.x, place.y, _HEIGHT_M]), ray)
    return not 0 <= float(distances[0]) < _STEP_M
