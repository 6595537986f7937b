"""Reflections, shears, projections and superimpositions of tf_transformations, with numpy.

As in that package, points in results have a fourth coordinate, which is 1.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from zbot.tf2.transformations import (
    Matrix,
    inverse_matrix,
    quaternion_from_matrix,
    translation_matrix,
    unit_vector,
)

Vector = npt.NDArray[np.float64]
_EPSILON = 1e-8


class NoSuchTransformError(ValueError):
    """A matrix is not of the kind that a function needs."""

    def __init__(self, kind: str) -> None:
        self.kind = kind
        super().__init__(f"the matrix is not a {kind}")


def _vector(data: Any) -> Vector:
    return np.asarray(data, dtype=float)[:3]


def _affine(linear: Any, offset: Any) -> Matrix:
    matrix = np.identity(4)
    matrix[:3, :3], matrix[:3, 3] = linear, offset
    return matrix


def _point(place: Any) -> Vector:
    return np.append(place, 1.0)


def _fixed_point(matrix: Matrix) -> Vector:
    """Return the matrix's fixed point that is nearest to the origin."""
    place, *_ = np.linalg.lstsq(np.identity(3) - matrix[:3, :3], matrix[:3, 3], rcond=None)
    return _point(place)


def random_vector(size: int) -> Vector:
    """Return random numbers from 0 to 1."""
    return np.random.default_rng().random(size)


def reflection_matrix(point: Any, normal: Any) -> Matrix:
    """Return the matrix that reflects at a plane. A point and the normal define the plane."""
    across = unit_vector(_vector(normal))
    flip = np.identity(3) - 2 * np.outer(across, across)
    return _affine(flip, 2 * (_vector(point) @ across) * across)


def reflection_from_matrix(matrix: Any) -> tuple[Vector, Vector]:
    """Return a point and the normal of the plane at which a matrix reflects.

    Raises:
        NoSuchTransformError: The matrix is not a reflection.
    """
    m = np.asarray(matrix, dtype=float)
    values, vectors = np.linalg.eigh((m[:3, :3] + m[:3, :3].T) / 2)
    if abs(values[0] + 1) > _EPSILON:
        raise NoSuchTransformError("reflection")
    return _point(m[:3, 3] / 2), vectors[
        :, 0
    ]  # the origin's image is at twice the plane's distance


def rotation_from_matrix(matrix: Any) -> tuple[float, Vector, Vector]:
    """Return the angle in rad, the axis and a point on the axis of a rotation matrix.

    Raises:
        NoSuchTransformError: The matrix is not a rotation.
    """
    m = np.asarray(matrix, dtype=float)
    turn = m[:3, :3]
    if not np.allclose(turn @ turn.T, np.identity(3)) or np.linalg.det(turn) < 0:
        raise NoSuchTransformError("rotation")
    x, y, z, w = quaternion_from_matrix(m)
    along, length = np.array([x, y, z]), math.hypot(x, y, z)
    axis = along / length if length > _EPSILON else np.array([0.0, 0.0, 1.0])
    return 2 * math.atan2(length, w), axis, _fixed_point(m)


def scale_from_matrix(matrix: Any) -> tuple[float, Vector, Vector | None]:
    """Return the factor, the origin and the direction of a scaling matrix.

    The direction is `None` for a matrix that scales uniformly.

    Raises:
        NoSuchTransformError: The matrix is not a scaling.
    """
    m = np.asarray(matrix, dtype=float)
    values, vectors = np.linalg.eigh((m[:3, :3] + m[:3, :3].T) / 2)
    origin = _fixed_point(m)
    if not np.allclose(m @ origin, origin):
        raise NoSuchTransformError("scale")
    if np.allclose(values, values.mean()):
        return float(values.mean()), origin, None
    odd = int(np.argmax(np.abs(values - 1)))
    return float(values[odd]), origin, vectors[:, odd]


def shear_matrix(angle: float, direction: Any, point: Any, normal: Any) -> Matrix:
    """Return the matrix that shears by an angle in rad along a direction in a plane.

    Raises:
        ValueError: The direction does not lie in the plane.
    """
    across, along = unit_vector(_vector(normal)), unit_vector(_vector(direction))
    if abs(across @ along) > 1e-6:
        raise ValueError("a shear's direction must be at right angles to its normal")
    slope = math.tan(angle)
    linear = np.identity(3) + slope * np.outer(along, across)
    return _affine(linear, -slope * (_vector(point) @ across) * along)


def shear_from_matrix(matrix: Any) -> tuple[float, Vector, Vector, Vector]:
    """Return the angle, direction, a point and the normal of a shear.

    Raises:
        NoSuchTransformError: The matrix is not a shear.
    """
    m = np.asarray(matrix, dtype=float)
    directions, slopes, normals = np.linalg.svd(m[:3, :3] - np.identity(3))
    along, across, slope = directions[:, 0], normals[0], float(slopes[0])
    if slope < _EPSILON or slopes[1] > _EPSILON or abs(along @ across) > _EPSILON:
        raise NoSuchTransformError("shear")
    return math.atan(slope), along, _point(-(m[:3, 3] @ along) / slope * across), across


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
        pseudo: Whether a perspective keeps the order of depths.
    """
    across = unit_vector(_vector(normal))
    height = _vector(point) @ across
    if perspective is None:
        ray = across if direction is None else _vector(direction)
        ray = ray / (ray @ across)
        return _affine(np.identity(3) - np.outer(ray, across), height * ray)
    # The ray from the eye through x meets the plane at
    # ((n.(eye - p)) x - (n.x - n.p) eye) / (n.(eye - x)).
    eye = _vector(perspective)
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
        NoSuchTransformError: The matrix is not a projection.
    """
    m = np.asarray(matrix, dtype=float)
    steepness = float(np.linalg.norm(m[3, :3]))
    if steepness > _EPSILON:
        return _perspective(m / steepness, pseudo=pseudo)
    m = m / m[3, 3]
    rays, values, normals = np.linalg.svd(m[:3, :3].T)
    if values[2] > _EPSILON:
        raise NoSuchTransformError("projection")
    # The matrix maps the ray to 0. The transpose of the matrix maps the normal to 0.
    return _point(m[:3, 3]), normals[2], rays[:, 2], None, False


def _perspective(
    m: Matrix, *, pseudo: bool
) -> tuple[Vector, Vector, Vector | None, Vector | None, bool]:
    across = -m[3, :3]
    aside = unit_vector(np.cross(across, np.identity(3)[int(np.argmin(np.abs(across)))]))
    distance = aside @ m[:3, :3] @ aside
    eye = distance * across - m[:3, :3] @ across - (across if pseudo else 0)
    return _point((eye @ across - distance) * across), across, None, eye, pseudo


def clip_matrix(  # noqa: PLR0917 - the order of OpenGL, and of tf_transformations
    left: float,
    right: float,
    bottom: float,
    top: float,
    near: float,
    far: float,
    perspective: bool = False,
) -> Matrix:
    """Return the matrix that maps a box to -1 ... 1. With `perspective`, it maps a frustum.

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
        return _affine(np.diag(2 / size), -(high + low) / size)
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
    return _affine(edges, np.zeros(3))


def superimposition_matrix(v0: Any, v1: Any, scaling: bool = False, usesvd: bool = True) -> Matrix:
    """Return the matrix of a rotation and translation that best maps points to other points.

    Args:
        v0: The points, one per column.
        v1: The points to which they are mapped.
        scaling: Whether the matrix may also scale.
        usesvd: Accepted without effect.
    """
    del usesvd
    start, goal = np.asarray(v0, dtype=float)[:3], np.asarray(v1, dtype=float)[:3]
    centres: tuple[Vector, Vector] = start.mean(axis=1), goal.mean(axis=1)
    start, goal = start - centres[0][:, None], goal - centres[1][:, None]
    left, _, right = np.linalg.svd(goal @ start.T)
    # Kabsch's algorithm. The sign excludes reflections, which may fit better than any rotation.
    handedness = np.diag([1.0, 1.0, np.sign(np.linalg.det(left @ right))])
    turn = left @ handedness @ right
    if scaling:
        turn = turn * float(np.linalg.norm(goal) / np.linalg.norm(start))
    there = translation_matrix(centres[1]) @ _affine(turn, np.zeros(3))
    moved: Matrix = there @ inverse_matrix(translation_matrix(centres[0]))
    return moved
