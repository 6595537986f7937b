"""Fewer triangles for surfaces that are small on the screen.

The browser makes the simpler surfaces, and chooses one by the distance of the camera. Triangles are
what costs most where WebGL runs in software (docs/design/view.md).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from zbot.view.shape import Mesh

#: A surface with fewer triangles is always drawn whole.
FEW_TRIANGLES = 1000
# From so many radii of the surface on, so many triangles are enough: a triangle has some pixels.
_ENOUGH = ((4.0, 5000), (8.0, 1500), (16.0, 500), (32.0, 150))
#: A simpler surface must save at least this part of the triangles.
_LEAST_SAVING = 0.3


def centre_and_radius(mesh: Mesh) -> tuple[tuple[float, float, float], float]:
    """Return the middle of a surface's box, and how far the surface is from it at most."""
    middle = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    x, y, z = (float(part) for part in middle)
    lengths = np.linalg.norm(mesh.vertices - middle, axis=1)
    return (x, y, z), float(np.max(lengths))


def levels(triangles: int, radius: float) -> tuple[tuple[float, float], ...]:
    """Return distances in metres, each with the part of the triangles that is enough from there on.

    Args:
        triangles: The number of triangles of the surface.
        radius: Its radius in metres.
    """
    found: list[tuple[float, float]] = []
    left = float(triangles)
    for radii, enough in _ENOUGH:
        if enough < left * (1 - _LEAST_SAVING):
            found.append((radii * radius, enough / triangles))
            left = enough
    return tuple(found)
