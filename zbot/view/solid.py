"""Surfaces of simple solids around the origin, each with a size of 1 m."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Surface = tuple[NDArray[np.float32], NDArray[np.uint32]]

_SIDES = 24
_RINGS = 12


@lru_cache(1)
def box() -> Surface:
    """Return the vertices and the triangles of a cube with edges of 1 m."""
    corners = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
    squares = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    vertices: list[tuple[float, float, float]] = []
    faces: list[tuple[int, int, int]] = []
    for a, b, c, d in squares:  # own vertices for each side: its edges are sharp
        first = len(vertices)
        vertices += [corners[index] for index in (a, b, c, d)]
        faces += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return np.array(vertices, np.float32), np.array(faces, np.uint32)


@lru_cache(1)
def cylinder() -> Surface:
    """Return the surface of a cylinder along z with a diameter and a height of 1 m."""
    turn = np.arange(_SIDES) * (2 * math.pi / _SIDES)
    ring = np.stack([np.cos(turn) / 2, np.sin(turn) / 2, np.zeros(_SIDES)], axis=1)
    up = np.array((0, 0, 0.5))
    low, high = ring - up, ring + up
    ends = np.array([(0, 0, -0.5), (0, 0, 0.5)])
    vertices = np.concatenate([low, high, low, high, ends])
    one, two = np.arange(_SIDES), np.roll(np.arange(_SIDES), -1)
    bottom, top = 4 * _SIDES, 4 * _SIDES + 1
    faces = np.concatenate(
        [
            np.stack([one, two, two + _SIDES], axis=1),
            np.stack([one, two + _SIDES, one + _SIDES], axis=1),
            np.stack([two + 2 * _SIDES, one + 2 * _SIDES, np.full(_SIDES, bottom)], axis=1),
            np.stack([one + 3 * _SIDES, two + 3 * _SIDES, np.full(_SIDES, top)], axis=1),
        ]
    )
    return vertices.astype(np.float32), faces.astype(np.uint32)


@lru_cache(1)
def sphere() -> Surface:
    """Return the surface of a sphere with a diameter of 1 m."""
    turn = np.arange(_SIDES + 1) * (2 * math.pi / _SIDES)
    tilt = np.arange(_RINGS + 1) * (math.pi / _RINGS)
    tilts, turns = np.meshgrid(tilt, turn, indexing="ij")
    rows = [np.sin(tilts) * np.cos(turns), np.sin(tilts) * np.sin(turns), np.cos(tilts)]
    vertices = np.stack(rows, axis=-1).reshape(-1, 3) / 2
    ring, side = np.meshgrid(np.arange(_RINGS), np.arange(_SIDES), indexing="ij")
    first = (ring * (_SIDES + 1) + side).reshape(-1)
    below = first + _SIDES + 1
    faces = np.concatenate(
        [
            np.stack([first, below, below + 1], axis=1),
            np.stack([first, below + 1, first + 1], axis=1),
        ]
    )
    return vertices.astype(np.float32), faces.astype(np.uint32)
