"""Pieces of a mesh that never moves: convex solids, which together have the shape of the mesh.

The physics knows only convex solids. A wall around a room would fill the room.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from zbot.simulation.meshes.hull import THICKNESS_M, is_flat

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Triangles = NDArray[np.float64]
    Points = NDArray[np.float64]

#: A piece is convex if no point is further than this in front of one of its triangles.
_TOLERANCE_M = 0.01
#: A piece with more triangles is always divided, because the test of all pairs would take long.
_MOST_TRIANGLES = 1500
_MOST_PIECES = 3000


def convex_pieces(triangles: Triangles) -> list[Points]:
    """Return the corners of convex solids that have the shape of a mesh together.

    Args:
        triangles: The triangles, in metres.

    Returns:
        The solids. If a mesh needs more than 3,000, the last ones are coarse.
    """
    sides = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    areas = np.linalg.norm(sides, axis=1)
    kept = areas > 1e-12
    triangles, normals = triangles[kept], sides[kept] / areas[kept, None]
    waiting = _connected(triangles)
    found: list[Points] = []
    while waiting:
        part = waiting.pop()
        is_last = len(found) + len(waiting) > _MOST_PIECES
        if not is_last and not _is_convex(triangles[part], normals[part]):
            waiting += _halves(triangles, part)
            continue
        points = np.unique(triangles[part].reshape(-1, 3), axis=0)
        found.append(_thickened(points, normals[part]))
    return found


def _is_convex(triangles: Triangles, normals: Points) -> bool:
    if len(triangles) > _MOST_TRIANGLES:
        return False
    points = np.unique(triangles.reshape(-1, 3), axis=0)
    heights = points @ normals.T - (triangles[:, 0] * normals).sum(axis=1)
    return bool(heights.max() <= _TOLERANCE_M)


def _halves(triangles: Triangles, part: NDArray[np.int64]) -> list[NDArray[np.int64]]:
    """Divide a part in the middle of its longest side."""
    middles = triangles[part].mean(axis=1)
    axis = int(np.argmax(np.ptp(middles, axis=0)))
    order = np.argsort(middles[:, axis], kind="stable")
    half = len(part) // 2
    return [part[order[:half]], part[order[half:]]]


def _thickened(points: Points, normals: Points) -> Points:
    """Return points that enclose some space. A surface gets a back side."""
    if not is_flat(points):
        return points
    normal = normals[0]
    return np.concatenate([points, points - normal * THICKNESS_M])


def _connected(triangles: Triangles) -> list[NDArray[np.int64]]:
    """Return the numbers of the triangles of each part whose triangles share points."""
    if not len(triangles):
        return []
    rounded = np.round(triangles.reshape(-1, 3), 5)
    _, names = np.unique(rounded, axis=0, return_inverse=True)
    corners = names.reshape(-1, 3)
    labels = np.arange(int(np.max(corners)) + 1)
    while True:  # each point takes the lowest label of its triangles, until nothing changes
        own = labels[corners]
        lowest = np.repeat(own.min(axis=1), 3)
        before = labels.copy()
        np.minimum.at(labels, corners.ravel(), lowest)
        # The points with the old labels take it, too: else a long strip would need many rounds.
        np.minimum.at(labels, own.ravel(), lowest)
        labels = labels[labels]
        if np.array_equal(before, labels):
            break
    of_triangles = labels[corners[:, 0]]
    order = np.argsort(of_triangles, kind="stable")
    edges = np.flatnonzero(np.diff(of_triangles[order])) + 1
    return np.split(order, edges)
