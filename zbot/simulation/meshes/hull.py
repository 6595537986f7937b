"""Hull of a mesh: the convex solid that the physics uses for a part of a robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.libraries.robot_description.mesh_address import path_of
from zbot.simulation.engine import engine
from zbot.simulation.errors import SimulationError
from zbot.simulation.meshes.file import ENDINGS, read_points

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from zbot.libraries.robot_description.appearance import Solid

#: Thickness of a mesh that is a sheet.
THICKNESS_M = 0.01
_LEAST_M = 1e-5


def add_mesh(spec: Any, solid: Solid) -> dict[str, Any] | str:
    """Add the hull of a mesh to a world. Return its shape, or why the mesh is left out.

    Raises:
        SimulationError: The file does not exist, is too large or is damaged.
        DescriptionError: The address is not that of a file.
    """
    path = path_of(solid.file)
    if path.suffix.lower() not in ENDINGS:
        return f"the collision of {path.name}: only STL, OBJ and COLLADA files collide"
    name = f"{solid.file} {solid.size}"
    if spec.mesh(name) is None:
        points = read_points(path) * np.array(solid.size)
        check_points(points, path)
        solid_points = _solid(points.astype(np.float64))
        if solid_points is None:
            return f"the collision of {path.name}, which has no surface,"
        spec.add_mesh(name=name, uservert=solid_points.ravel())
    return {"type": engine().mjtGeom.mjGEOM_MESH, "meshname": name}


def _solid(points: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Return points that enclose some space, or None for a line. A sheet gets a back side."""
    if not is_flat(points):
        return points
    middle = points.mean(axis=0) if len(points) else np.zeros(3)
    _, sizes, axes = np.linalg.svd(points - middle, full_matrices=False)
    if len(points) < 3 or sizes[1] < _LEAST_M:
        return None
    return np.concatenate([points, points + axes[2] * THICKNESS_M])


def check_points(points: NDArray[Any], path: Path) -> None:
    """Refuse points that are very far away.

    Raises:
        SimulationError: A point is too far away, or not finite.
    """
    if not np.isfinite(points).all() or np.abs(points).max(initial=0) > 1e4:
        raise SimulationError(f"{path} has points that are not within 10 km")


def is_flat(points: NDArray[Any]) -> bool:
    """Return whether points enclose no space."""
    return bool(len(points) < 4 or np.linalg.matrix_rank(points - points[0], tol=1e-5) < 3)
