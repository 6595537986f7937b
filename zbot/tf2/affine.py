"""Reflections, shears, projections and superimpositions of tf_transformations, with numpy.

As in that package, points in results have a fourth coordinate, which is 1.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from transforms3d import axangles, reflections, shears, zooms

from zbot.tf2.transformations import (
    Matrix,
    Vector,
    inverse_matrix,
    matrix_of,
    translation_matrix,
    unit_vector,
    vector3,
)

if TYPE_CHECKING:
    from collections.abc import Callable

_EPSILON = 1e-8


def random_vector(size: int) -> Vector:
    """Return random numbers from 0 to 1."""
    return np.random.default_rng().random(size)


def reflection_matrix(point: Any, normal: Any) -> Matrix:
    """Return the matrix that reflects at a plane. A point and the normal define the plane."""
    mirror: Matrix = reflections.rfnorm2aff(vector3(normal), vector3(point))
    return mirror


def reflection_from_matrix(matrix: Any) -> tuple[Vector, Vector]:
    """Return a point and the normal of the plane at which a matrix reflects.

    Raises:
        ValueError: The matrix is not a reflection.
    """
    parts = _parts("reflection", reflections.aff2rfnorm, reflections.rfnorm2aff, matrix)
    return parts[1], parts[0]


def rotation_from_matrix(matrix: Any) -> tuple[float, Vector, Vector]:
    """Return the angle in rad, the axis and a point on the axis of a rotation matrix.

    Raises:
        ValueError: The matrix is not a rotation.
    """
    direction, angle, point = _parts("rotation", axangles.aff2axangle, axangles.axangle2aff, matrix)
    return float(angle), direction, point


def scale_from_matrix(matrix: Any) -> tuple[float, Vector, Vector | None]:
    """Return the factor, the origin and the direction of a scaling matrix.

    The direction is `None` for a matrix that scales uniformly.

    Raises:
        ValueError: The matrix is not a scaling.
    """
    factor, direction, origin = _parts("scale", zooms.aff2zfdir, zooms.zfdir2aff, matrix)
    return float(factor), origin, direction


def shear_matrix(angle: float, direction: Any, point: Any, normal: Any) -> Matrix:
    """Return the matrix that shears by an angle in rad along a direction in a plane.

    Raises:
        ValueError: The direction does not lie in the plane.
    """
    if abs(unit_vector(vector3(normal)) @ unit_vector(vector3(direction))) > 1e-6:
        raise ValueError("a shear's direction must be at right angles to its normal")
    sheared: Matrix = shears.sadn2aff(angle, vector3(direction), vector3(normal), vector3(point))
    return sheared


def shear_from_matrix(matrix: Any) -> tuple[float, Vector, Vector, Vector]:
    """Return the angle, direction, a point and the normal of a shear.

    Raises:
        ValueError: The matrix is not a shear.
    """
    angle, direction, normal, point = _parts("shear", shears.aff2sadn, shears.sadn2aff, matrix)
    return float(angle), direction, point, normal


def _parts(
    kind: str, take_apart: Callable[..., Any], compose: Callable[..., Any], matrix: Any
) -> tuple[Any, ...]:
    """Take a matrix apart, and check that its parts give the same matrix again.

    For many matrices of another kind, transforms3d returns infinite or wrong numbers.
    """
    m = np.array(matrix, dtype=float)
    try:
        with np.errstate(all="ignore"):
            parts = tuple(take_apart(m))
            again = compose(*(vector3(part) if np.ndim(part) else part for part in parts))
    except ValueError:
        parts, again = (), np.nan
    if not np.allclose(again, m):
        raise ValueError(f"the matrix is not a {kind}")
    return parts


def projection_matrix(
    point: Any,
    normal: Any,
    direction: Any = None,
    perspective: Any = None,
    pseudo: bool = False,
) -> Matrix:
    """Return the matrix that projects onto a plane.

    Args:
        point: A point of the plane.
        normal: The normal of the plane.
        direction: Direction of the rays. The default is at right angles to the plane.
        perspective: Point from which the rays start, instead of a direction.
        pseudo: Whether a perspective projection keeps the order of the points in depth.
    """
    across = unit_vector(vector3(normal))
    height = vector3(point) @ across
    if perspective is None:
        ray = across if direction is None else vector3(direction)
        ray = ray / (ray @ across)
        return matrix_of(np.identity(3) - np.outer(ray, across), height * ray)
    # The ray from the eye through x meets the plane at
    # ((n.(eye - p)) x - (n.x - n.p) eye) / (n.(eye - x)).
    eye = vector3(perspective)
    matrix, depth = np.zeros((4, 4)), across if pseudo else np.zeros(3)
    matrix[:3, :3] = (eye @ across - height) * np.identity(3) - np.outer(eye + depth, across)
    matrix[:3, 3] = height * (eye + depth)
    matrix[3, :3], matrix[3, 3] = -across, eye @ across
    return matrix


def projection_from_matrix(
    matrix: Any, pseudo: bool = False
) -> tuple[Vector, Vector, Vector | None, Vector | None, bool]:
    """Return the arguments with which `projection_matrix` returns a given matrix.

    Raises:
        ValueError: The matrix is not a projection.
    """
    m = np.asarray(matrix, dtype=float)
    steepness = float(np.linalg.norm(m[3, :3]))
    if steepness > _EPSILON:
        return _perspective(m / steepness, pseudo=pseudo)
    m = m / m[3, 3]
    rays, values, normals = np.linalg.svd(m[:3, :3].T)
    if values[2] > _EPSILON:
        raise ValueError("the matrix is not a projection")
    # The matrix maps the ray to 0. The transpose of the matrix maps the normal to 0.
    return np.append(m[:3, 3], 1.0), normals[2], rays[:, 2], None, False


def _perspective(
    m: Matrix, *, pseudo: bool
) -> tuple[Vector, Vector, Vector | None, Vector | None, bool]:
    across = -m[3, :3]
    aside = unit_vector(np.cross(across, np.identity(3)[int(np.argmin(np.abs(across)))]))
    distance = aside @ m[:3, :3] @ aside
    eye = distance * across - m[:3, :3] @ across - (across if pseudo else 0)
    return np.append((eye @ across - distance) * across, 1.0), across, None, eye, pseudo


def clip_matrix(  # noqa: PLR0917 - the order of OpenGL, and of tf_transformations
    left: float,
    right: float,
    bottom: float,
    top: float,
    near: float,
    far: float,
    perspective: bool = False,
) -> Matrix:
    """Return the matrix that maps a box, or with `perspective` a frustum, to the range -1 to 1.

    Raises:
        ValueError: The box has no volume, or the near plane of the frustum is behind the eye.
    """
    if left >= right or bottom >= top or near >= far:
        raise ValueError("a box needs left < right, bottom < top and near < far")
    if perspective and near <= _EPSILON:
        raise ValueError("a frustum's near plane must be in front of the eye")
    low, high = np.array([left, bottom, near]), np.array([right, top, far])
    size = high - low
    if not perspective:
        return matrix_of(np.diag(2 / size), -(high + low) / size)
    matrix = np.zeros((4, 4))
    matrix[[0, 1], [0, 1]] = -2 * near / size[:2]
    matrix[:2, 2] = ((high + low) / size)[:2]
    matrix[2, 2:] = -(far + near) / size[2], 2 * near * far / size[2]
    matrix[3, 2] = -1.0
    return matrix


def orthogonalization_matrix(lengths: Any, angles: Any) -> Matrix:
    """Return the matrix from a crystal's coordinates to rectangular coordinates.

    Args:
        lengths: Lengths of the cell's edges.
        angles: Angles between the edges, in degrees.
    """
    a, b, c = lengths
    alpha, beta, gamma = np.radians(angles)
    # The third edge lies along z. The second edge lies in the plane of y and z.
    y = (math.cos(gamma) - math.cos(alpha) * math.cos(beta)) / math.sin(alpha)
    x = math.sqrt(math.sin(beta) ** 2 - y**2)
    edges = [
        [a * x, 0.0, 0.0],
        [a * y, b * math.sin(alpha), 0.0],
        [a * math.cos(beta), b * math.cos(alpha), c],
    ]
    return matrix_of(edges, np.zeros(3))


def superimposition_matrix(v0: Any, v1: Any, scaling: bool = False, usesvd: bool = True) -> Matrix:
    """Return the matrix of a rotation and translation that best maps points to other points.

    Args:
        v0: The points, one per column.
        v1: The points to which they are mapped.
        scaling: Whether the matrix may also scale.
        usesvd: Accepted without effect.

    Raises:
        ValueError: The sets differ in their number of points, or have less than 3.
    """
    del usesvd
    start, goal = vector3(v0), vector3(v1)
    if start.shape != goal.shape or start.ndim != 2 or start.shape[1] < 3:
        raise ValueError("both sets need the same number of points, at least 3, one per column")
    centres: tuple[Vector, Vector] = start.mean(axis=1), goal.mean(axis=1)
    start, goal = start - centres[0][:, None], goal - centres[1][:, None]
    left, _, right = np.linalg.svd(goal @ start.T)
    # Kabsch's algorithm. The sign excludes reflections, which may fit better than any rotation.
    handedness = np.diag([1.0, 1.0, np.sign(np.linalg.det(left @ right))])
    turn = left @ handedness @ right
    if scaling:
        turn = turn * float(np.linalg.norm(goal) / np.linalg.norm(start))
    there = translation_matrix(centres[1]) @ matrix_of(turn, np.zeros(3))
    moved: Matrix = there @ inverse_matrix(translation_matrix(centres[0]))
    return moved
