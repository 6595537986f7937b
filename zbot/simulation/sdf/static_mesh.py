"""Mesh that never moves, e.g. a wall or a house: the convex pieces of its file in a world."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.simulation.engine import engine
from zbot.simulation.errors import SimulationError
from zbot.simulation.meshes.file import ENDINGS, read_triangles
from zbot.simulation.meshes.hull import check_points
from zbot.simulation.meshes.pieces import convex_pieces

if TYPE_CHECKING:
    from zbot.libraries.robot_description.appearance import Solid

_MOST_TRIANGLES, _MOST_PIECES = 300_000, 10_000


def add_static_mesh(spec: Any, solid: Solid) -> list[str] | str:
    """Add the pieces of a mesh to a world. Return their names, or why the mesh is left out.

    Raises:
        SimulationError: The file is too large.
    """
    path = Path(solid.file)
    if path.suffix.lower() not in ENDINGS:
        return f"the mesh {path.name}: only STL, OBJ and COLLADA files collide"
    start = f"{solid.file} {solid.size} "
    if spec.mesh(f"{start}0") is not None:  # another model has the same mesh
        names = (mesh.name for mesh in spec.meshes)
        return [name for name in names if name.startswith(start)]
    triangles = read_triangles(path).astype(np.float64) * np.array(solid.size)
    check_points(triangles, path)
    if len(triangles) > _MOST_TRIANGLES:
        limit = _MOST_TRIANGLES
        raise SimulationError(f"{path} has {len(triangles)} triangles: the limit is {limit}")
    if len(spec.meshes) > _MOST_PIECES:
        raise SimulationError(f"the meshes of the world need more than {_MOST_PIECES} pieces")
    shell = engine().mjtMeshInertia.mjMESH_INERTIA_SHELL
    found = []
    for number, points in enumerate(convex_pieces(triangles)):
        name = f"{start}{number}"
        spec.add_mesh(name=name, uservert=points.ravel(), inertia=shell)
        found.append(name)
    return found
