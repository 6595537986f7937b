"""Rotations of ROS 2's tf_transformations, based on transforms3d. Quaternions are x y z w.

Names of axes are those of transforms3d. `sxyz` rotates about the fixed axes x, y, z in this order.
`rzyx` rotates about the axes z, y, x of the rotating body. The tuples of transforms3d, such as
(0, 0, 0, 0) for `sxyz`, are valid too.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.errors import MissingPackageError

try:
    import numpy as np
    import numpy.typing as npt
    from transforms3d import affines, axangles, euler, quaternions, zooms
except ModuleNotFoundError as error:
    if error.name not in {"numpy", "transforms3d"}:
        raise
    raise MissingPackageError("tf_transformations", error.name, "numpy") from None

if TYPE_CHECKING:
    from collections.abc import Callable

Matrix = npt.NDArray[np.float64]
Vector = npt.NDArray[np.float64]
Quaternion = tuple[float, float, float, float]

#: Parts of a transform that changes nothing.
TRANSLATION_IDENTITY = [0.0, 0.0, 0.0]
ROTATION_IDENTITY = np.identity(3)
ZOOM_IDENTITY = [1.0, 1.0, 1.0]
SHEAR_IDENTITY = TRANSLATION_IDENTITY

_EPSILON = 1e-12


def identity_matrix() -> Matrix:
    """Return the 4 x 4 identity matrix."""
    return np.identity(4)


def vector_norm(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """Return the length of a vector, or of each vector along an axis of an array.

    Args:
        data: A vector or an array of vectors.
        axis: The axis of the vectors. Without an axis, all numbers together are one vector.
        out: An array for the lengths. The function then returns `None`.
    """
    numbers = np.array(data, dtype=float)
    if out is None and numbers.ndim == 1:
        return float(np.linalg.norm(numbers))
    lengths = np.sqrt(np.sum(numbers * numbers, axis=axis))
    if out is None:
        return np.atleast_1d(lengths)
    out[...] = lengths
    return None


def unit_vector(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """Return a vector of length 1 in the same direction, or an array of such vectors.

    Args:
        data: A vector or an array of vectors.
        axis: The axis of the vectors. Without an axis, all numbers together are one vector.
        out: An array for the result, which may be `data`. The function then returns `None`.
    """
    numbers = np.array(data, dtype=float)
    numbers /= np.sqrt(np.sum(numbers * numbers, axis=axis, keepdims=True))
    if out is None:
        return numbers
    out[...] = numbers
    return None


def translation_matrix(direction: Any) -> Matrix:
    """Return the 4 x 4 matrix that translates by a vector."""
    return matrix_of(ROTATION_IDENTITY, vector3(direction))


def translation_from_matrix(matrix: Any) -> Vector:
    """Return the translation vector of a matrix."""
    column: Vector = np.array(matrix, dtype=float)[:3, 3]
    return column


def scale_matrix(factor: float, origin: Any = None, direction: Any = None) -> Matrix:
    """Return the 4 x 4 matrix that scales about a point, in one or all directions."""
    scaled: Matrix = zooms.zfdir2aff(factor, _optional(direction), _optional(origin))
    return scaled


def rotation_matrix(angle: float, direction: Any, point: Any = None) -> Matrix:
    """Return the 4 x 4 matrix that rotates by an angle in rad about an axis through a point."""
    turned: Matrix = axangles.axangle2aff(vector3(direction), angle, _optional(point))
    return turned


def concatenate_matrices(*matrices: Any) -> Matrix:
    """Return the product of matrices. The last matrix is applied first."""
    product = np.identity(4)
    for matrix in matrices:
        product = product @ np.asarray(matrix, dtype=float)
    return product


def inverse_matrix(matrix: Any) -> Matrix:
    """Return the inverse of a matrix."""
    return np.linalg.inv(np.asarray(matrix, dtype=float))


def compose_matrix(
    scale: Any = None,
    shear: Any = None,
    angles: Any = None,
    translate: Any = None,
    perspective: Any = None,
) -> Matrix:
    """Return the matrix that shears, scales, rotates, translates and projects, in this order.

    Args:
        scale: Factors along x, y and z.
        shear: Shear factors of x by y, x by z, and y by z.
        angles: Angles for `sxyz`, in rad.
        translate: Translation vector.
        perspective: Last row of the matrix. ROS 2's function ignores it.
    """
    composed: Matrix = affines.compose(
        TRANSLATION_IDENTITY if translate is None else translate,
        ROTATION_IDENTITY if angles is None else euler.euler2mat(*angles),
        ZOOM_IDENTITY if scale is None else scale,
        SHEAR_IDENTITY if shear is None else shear,
    )
    if perspective is not None:
        projection = np.identity(4)
        projection[3] = np.asarray(perspective, dtype=float)[:4]
        composed = projection @ composed
        composed /= composed[3, 3]
    return composed


def decompose_matrix(
    matrix: Any,
) -> tuple[Vector, Vector, tuple[float, float, float], Vector, Vector]:
    """Return scale, shear, angles, translation and perspective, the arguments of `compose_matrix`.

    Raises:
        ValueError: The matrix maps everything to a plane, or the origin to infinity.
    """
    m = np.array(matrix, dtype=float)
    if abs(m[3, 3]) < _EPSILON or abs(np.linalg.det(m[:3, :3])) < _EPSILON:
        raise ValueError("the matrix is singular: it cannot be decomposed")
    m /= m[3, 3]
    rest = np.vstack([m[:3], [0.0, 0.0, 0.0, 1.0]])
    translation, turn, zoom, shear = affines.decompose44(rest)
    return zoom, shear, euler_from_matrix(turn), translation, m[3] @ np.linalg.inv(rest)


def euler_matrix(ai: float, aj: float, ak: float, axes: Any = "sxyz") -> Matrix:
    """Return the 4 x 4 matrix of three angles in rad."""
    return matrix_of(_with_axes(euler.euler2mat, ai, aj, ak, axes=axes), TRANSLATION_IDENTITY)


def euler_from_matrix(matrix: Any, axes: Any = "sxyz") -> tuple[float, float, float]:
    """Return the three angles of a rotation matrix, in rad."""
    # transforms3d's own conversion to an array fails with numpy 2.
    a, b, c = _with_axes(euler.mat2euler, np.array(matrix, dtype=float), axes=axes)
    return float(a), float(b), float(c)


def euler_from_quaternion(quaternion: Any, axes: Any = "sxyz") -> tuple[float, float, float]:
    """Return the three angles of a rotation in rad. For `sxyz` they are roll, pitch and yaw."""
    return euler_from_matrix(quaternions.quat2mat(_wxyz(quaternion)), axes)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Any = "sxyz") -> Quaternion:
    """Return the rotation of three angles in rad. For `sxyz` they are roll, pitch and yaw."""
    return _xyzw(_with_axes(euler.euler2quat, ai, aj, ak, axes=axes))


def quaternion_about_axis(angle: float, axis: Any) -> Quaternion:
    """Return the rotation by an angle, in rad, about an axis."""
    return _xyzw(quaternions.axangle2quat(vector3(axis), angle))


def quaternion_matrix(quaternion: Any) -> Matrix:
    """Return the 4 x 4 matrix of a quaternion, which may have any length above 0."""
    return matrix_of(quaternions.quat2mat(_wxyz(quaternion)), TRANSLATION_IDENTITY)


def quaternion_from_matrix(matrix: Any) -> Quaternion:
    """Return the quaternion of the rotation in a 4 x 4 matrix. Its w is never negative."""
    turn = affines.decompose(np.array(matrix, dtype=float))[1]
    return _xyzw(quaternions.mat2quat(turn))


def quaternion_multiply(quaternion1: Any, quaternion0: Any) -> Quaternion:
    """Return the rotation that applies `quaternion0` and then `quaternion1`."""
    return _xyzw(quaternions.qmult(_wxyz(quaternion1), _wxyz(quaternion0)))


def quaternion_conjugate(quaternion: Any) -> Vector:
    """Return a quaternion with x, y and z negated."""
    return np.asarray(quaternion, dtype=float) * [-1.0, -1.0, -1.0, 1.0]


def quaternion_inverse(quaternion: Any) -> Vector:
    """Return the inverse rotation."""
    inverse: Vector = quaternion_conjugate(quaternion) / np.dot(quaternion, quaternion)
    return inverse


def quaternion_slerp(
    quat0: Any, quat1: Any, fraction: float, spin: int = 0, shortestpath: bool = True
) -> Vector:
    """Interpolate from `quat0` (`fraction` 0) to `quat1` (1) with `spin` extra full turns."""
    q0: Vector = unit_vector(quat0[:4])
    q1: Vector = unit_vector(quat1[:4])
    if fraction in {0.0, 1.0}:
        return q1 if fraction else q0
    cosine = float(np.dot(q0, q1))
    if abs(abs(cosine) - 1) < _EPSILON:
        return q0
    if shortestpath and cosine < 0:
        q1, cosine = -q1, -cosine
    angle = math.acos(cosine) + spin * math.pi
    if abs(angle) < _EPSILON:
        return q0
    weights = math.sin((1 - fraction) * angle), math.sin(fraction * angle)
    return (q0 * weights[0] + q1 * weights[1]) / math.sin(angle)


def random_rotation_matrix(rand: Any = None) -> Matrix:
    """Return a random rotation matrix. `rand` may give three numbers from 0 to 1."""
    return quaternion_matrix(random_quaternion(rand))


def random_quaternion(rand: Any = None) -> Vector:
    """Return a uniformly distributed rotation. `rand` may give three numbers from 0 to 1."""
    a, b, c = np.random.default_rng().random(3) if rand is None else np.asarray(rand, dtype=float)
    r1, r2 = math.sqrt(1 - a), math.sqrt(a)
    t1, t2 = 2 * math.pi * b, 2 * math.pi * c
    parts = [r1 * math.sin(t1), r1 * math.cos(t1), r2 * math.sin(t2), r2 * math.cos(t2)]
    return np.array(parts)


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Return whether two matrices are the same transform. A common factor makes no difference."""
    first, second = np.array(matrix0, dtype=float), np.array(matrix1, dtype=float)
    return bool(np.allclose(first / first[3, 3], second / second[3, 3]))


def matrix_of(linear: Any, offset: Any) -> Matrix:
    """Return the 4 x 4 matrix with a 3 x 3 part and a translation vector."""
    matrix = np.identity(4)
    matrix[:3, :3], matrix[:3, 3] = linear, offset
    return matrix


def vector3(data: Any) -> Vector:
    """Return the first three coordinates of a point or vector."""
    return np.asarray(data, dtype=float)[:3]


def _with_axes(function: Callable[..., Any], *arguments: Any, axes: Any) -> Any:
    try:
        return function(*arguments, axes=axes)
    except KeyError:
        raise KeyError(
            f"axes {axes!r} are unknown: use a name such as 'sxyz' (fixed) or 'rzyx' (rotating)"
        ) from None


def _optional(data: Any) -> Vector | None:
    return None if data is None else vector3(data)


def _wxyz(quaternion: Any) -> Vector:
    x, y, z, w = quaternion
    return np.array([w, x, y, z], dtype=float)


def _xyzw(quaternion: Any) -> Quaternion:
    w, x, y, z = map(float, quaternion)
    return x, y, z, w
