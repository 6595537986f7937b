"""Functions of ROS 2's tf_transformations, with numpy. Quaternions are x y z w.

Axes have the same names as in that package. `sxyz` rotates about the fixed axes x, y, z in this
order. `rzyx` rotates about the axes z, y, x of the rotating body.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

Matrix = npt.NDArray[np.float64]
Quaternion = npt.NDArray[np.float64]

_EPSILON = 1e-12
#: Items: first axis (0: x, 1: y, 2: z); 1 if the other axes follow in reverse order; 1 if the first
#: axis is also the last; 1 if the axes rotate with the body. Read `r` names from right to left.
_AXES: dict[str, tuple[int, int, int, int]] = {
    "sxyz": (0, 0, 0, 0),
    "sxyx": (0, 0, 1, 0),
    "sxzy": (0, 1, 0, 0),
    "sxzx": (0, 1, 1, 0),
    "syzx": (1, 0, 0, 0),
    "syzy": (1, 0, 1, 0),
    "syxz": (1, 1, 0, 0),
    "syxy": (1, 1, 1, 0),
    "szxy": (2, 0, 0, 0),
    "szxz": (2, 0, 1, 0),
    "szyx": (2, 1, 0, 0),
    "szyz": (2, 1, 1, 0),
    "rzyx": (0, 0, 0, 1),
    "rxyx": (0, 0, 1, 1),
    "ryzx": (0, 1, 0, 1),
    "rxzx": (0, 1, 1, 1),
    "rxzy": (1, 0, 0, 1),
    "ryzy": (1, 0, 1, 1),
    "rzxy": (1, 1, 0, 1),
    "ryxy": (1, 1, 1, 1),
    "ryxz": (2, 0, 0, 1),
    "rzxz": (2, 0, 1, 1),
    "rxyz": (2, 1, 0, 1),
    "rzyz": (2, 1, 1, 1),
}


def identity_matrix() -> Matrix:
    """Return the 4 x 4 identity matrix."""
    return np.identity(4)


def vector_norm(data: Any, axis: int | None = None) -> Any:
    """Return the length of a vector, or of each vector along an axis of an array."""
    return np.linalg.norm(np.asarray(data, dtype=float), axis=axis)


def unit_vector(data: Any) -> npt.NDArray[np.float64]:
    """Return a vector of length 1 in the same direction."""
    vector = np.asarray(data, dtype=float)
    unit: npt.NDArray[np.float64] = vector / np.linalg.norm(vector)
    return unit


def translation_matrix(direction: Any) -> Matrix:
    """Return the 4 x 4 matrix that translates by a vector."""
    matrix = np.identity(4)
    matrix[:3, 3] = np.asarray(direction, dtype=float)[:3]
    return matrix


def translation_from_matrix(matrix: Any) -> npt.NDArray[np.float64]:
    """Return the translation vector of a matrix."""
    column: npt.NDArray[np.float64] = np.array(matrix, dtype=float)[:3, 3].copy()
    return column


def scale_matrix(factor: float, origin: Any = None, direction: Any = None) -> Matrix:
    """Return the 4 x 4 matrix that scales about a point, in one or all directions."""
    matrix = np.identity(4)
    if direction is None:
        matrix[:3, :3] *= factor
    else:
        along = unit_vector(np.asarray(direction, dtype=float)[:3])
        matrix[:3, :3] -= (1 - factor) * np.outer(along, along)
    if origin is not None:
        point = np.asarray(origin, dtype=float)[:3]
        matrix[:3, 3] = point - matrix[:3, :3] @ point
    return matrix


def rotation_matrix(angle: float, direction: Any, point: Any = None) -> Matrix:
    """Return the 4 x 4 matrix that rotates by an angle in rad about an axis through a point."""
    matrix = quaternion_matrix(quaternion_about_axis(angle, direction))
    if point is not None:
        centre = np.asarray(point, dtype=float)[:3]
        matrix[:3, 3] = centre - matrix[:3, :3] @ centre
    return matrix


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
    """Return the matrix that scales, shears, rotates, translates and projects, in this order.

    Args:
        scale: Factors along x, y and z.
        shear: Shear factors of x by y, x by z, and y by z.
        angles: Angles for `sxyz`, in rad.
        translate: Translation vector.
        perspective: Last row of the matrix.
    """
    matrix = np.identity(4)
    if perspective is not None:
        matrix[3, :] = np.asarray(perspective, dtype=float)[:4]
    if translate is not None:
        matrix = matrix @ translation_matrix(translate)
    if angles is not None:
        roll, pitch, yaw = angles
        matrix = matrix @ euler_matrix(roll, pitch, yaw)
    if shear is not None:
        slant = np.identity(4)
        slant[0, 1], slant[0, 2], slant[1, 2] = shear
        matrix = matrix @ slant
    if scale is not None:
        matrix = matrix @ np.diag([*np.asarray(scale, dtype=float)[:3], 1.0])
    composed: Matrix = matrix / matrix[3, 3]
    return composed


def decompose_matrix(
    matrix: Any,
) -> tuple[
    npt.NDArray[np.float64],
    list[float],
    tuple[float, float, float],
    npt.NDArray[np.float64],
    npt.NDArray[np.float64],
]:
    """Return scale, shear, angles, translation and perspective, the arguments of `compose_matrix`.

    Raises:
        ValueError: The matrix maps everything to a plane, or the origin to infinity.
    """
    m = np.array(matrix, dtype=float)
    if abs(m[3, 3]) < _EPSILON or abs(np.linalg.det(m[:3, :3])) < _EPSILON:
        raise ValueError("the matrix is singular: it cannot be decomposed")
    m /= m[3, 3]
    affine = np.vstack([m[:3], [0.0, 0.0, 0.0, 1.0]])
    perspective = m[3] @ np.linalg.inv(affine)
    turned, upper = np.linalg.qr(m[:3, :3])
    signs = np.sign(np.diag(upper))  # of all decompositions, take the one with positive scales
    turned, upper = turned * signs, signs[:, None] * upper
    if np.linalg.det(turned) < 0:
        turned, upper = -turned, -upper
    scale = np.diag(upper).copy()
    x_y, x_z, y_z = upper[0, 1] / scale[1], upper[0, 2] / scale[2], upper[1, 2] / scale[2]
    angles = euler_from_matrix(turned)
    return scale, [float(x_y), float(x_z), float(y_z)], angles, m[:3, 3].copy(), perspective


def euler_matrix(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Matrix:
    """Return the 4 x 4 matrix of three angles in rad."""
    return quaternion_matrix(quaternion_from_euler(ai, aj, ak, axes))


def euler_from_matrix(matrix: Any, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the three angles of a rotation matrix, in rad."""
    first, parity, repetition, frame = _axes(axes)
    i, j, k = first, (first + 1 + parity) % 3, (first + 2 - parity) % 3
    m = np.array(matrix, dtype=float)[:3, :3]
    if repetition:
        sine = math.hypot(m[i, j], m[i, k])
        if sine > _EPSILON:
            angles = (
                math.atan2(m[i, j], m[i, k]),
                math.atan2(sine, m[i, i]),
                math.atan2(m[j, i], -m[k, i]),
            )
        else:
            angles = (math.atan2(-m[j, k], m[j, j]), math.atan2(sine, m[i, i]), 0.0)
    else:
        cosine = math.hypot(m[i, i], m[j, i])
        if cosine > _EPSILON:
            angles = (
                math.atan2(m[k, j], m[k, k]),
                math.atan2(-m[k, i], cosine),
                math.atan2(m[j, i], m[i, i]),
            )
        else:
            angles = (math.atan2(-m[j, k], m[j, j]), math.atan2(-m[k, i], cosine), 0.0)
    a, b, c = (-angle for angle in angles) if parity else angles
    return (c, b, a) if frame else (a, b, c)


def euler_from_quaternion(quaternion: Any, axes: str = "sxyz") -> tuple[float, float, float]:
    """Return the three angles of a rotation in rad. For `sxyz` they are roll, pitch and yaw."""
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: str = "sxyz") -> Quaternion:
    """Return the rotation of three angles in rad. For `sxyz` they are roll, pitch and yaw."""
    first, parity, repetition, frame = _axes(axes)
    i, j, k = first, (first + 1 + parity) % 3, (first + 2 - parity) % 3
    third = i if repetition else k
    if frame:
        ai, ak = ak, ai
    turns = [(ai, i), (aj, j), (ak, third)]
    result = np.array([0.0, 0.0, 0.0, 1.0])
    for angle, axis in turns:
        turn = np.zeros(4)
        turn[axis], turn[3] = math.sin(angle / 2), math.cos(angle / 2)
        result = quaternion_multiply(turn, result)
    return result


def quaternion_about_axis(angle: float, axis: Any) -> Quaternion:
    """Return the rotation by an angle, in rad, about an axis."""
    direction = np.asarray(axis, dtype=float)[:3]
    length = np.linalg.norm(direction)
    turn = np.zeros(4)
    if length > _EPSILON:
        turn[:3] = direction / length * math.sin(angle / 2)
    turn[3] = math.cos(angle / 2)
    return turn


def quaternion_matrix(quaternion: Any) -> Matrix:
    """Return the 4 x 4 matrix of a quaternion, which may have any length above 0."""
    x, y, z, w = np.asarray(quaternion, dtype=float)[:4]
    square = x * x + y * y + z * z + w * w
    matrix = np.identity(4)
    if square < _EPSILON:
        return matrix
    s = 2.0 / square
    matrix[:3, :3] = [
        [1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)],
        [s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)],
        [s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)],
    ]
    return matrix


def quaternion_from_matrix(matrix: Any) -> Quaternion:
    """Return the quaternion of a rotation matrix."""
    m = np.array(matrix, dtype=float)[:3, :3]
    trace = float(np.trace(m))
    if trace > 0:
        s = 2 * math.sqrt(1 + trace)
        parts = [(m[2, 1] - m[1, 2]) / s, (m[0, 2] - m[2, 0]) / s, (m[1, 0] - m[0, 1]) / s, s / 4]
        return np.array(parts)
    i = int(np.argmax(np.diag(m)))
    j, k = (i + 1) % 3, (i + 2) % 3
    s = 2 * math.sqrt(max(1 + m[i, i] - m[j, j] - m[k, k], _EPSILON))
    result = np.zeros(4)
    result[i] = s / 4
    result[j] = (m[j, i] + m[i, j]) / s
    result[k] = (m[k, i] + m[i, k]) / s
    result[3] = (m[k, j] - m[j, k]) / s
    return result


def quaternion_multiply(quaternion1: Any, quaternion0: Any) -> Quaternion:
    """Return the rotation that applies `quaternion0` and then `quaternion1`."""
    x1, y1, z1, w1 = np.asarray(quaternion1, dtype=float)
    x0, y0, z0, w0 = np.asarray(quaternion0, dtype=float)
    return np.array(
        [
            w1 * x0 + x1 * w0 + y1 * z0 - z1 * y0,
            w1 * y0 - x1 * z0 + y1 * w0 + z1 * x0,
            w1 * z0 + x1 * y0 - y1 * x0 + z1 * w0,
            w1 * w0 - x1 * x0 - y1 * y0 - z1 * z0,
        ]
    )


def quaternion_conjugate(quaternion: Any) -> Quaternion:
    """Return a quaternion with x, y and z negated."""
    return np.asarray(quaternion, dtype=float) * [-1.0, -1.0, -1.0, 1.0]


def quaternion_inverse(quaternion: Any) -> Quaternion:
    """Return the inverse rotation."""
    parts = np.asarray(quaternion, dtype=float)
    inverse: Quaternion = quaternion_conjugate(parts) / np.dot(parts, parts)
    return inverse


def quaternion_slerp(
    quat0: Any, quat1: Any, fraction: float, spin: int = 0, shortestpath: bool = True
) -> Quaternion:
    """Interpolate from `quat0` (`fraction` 0) to `quat1` (1) with `spin` extra full turns."""
    q0, q1 = unit_vector(quat0), unit_vector(quat1)
    cosine = float(np.dot(q0, q1))
    if shortestpath and cosine < 0:
        q1, cosine = -q1, -cosine
    if fraction in {0.0, 1.0} or abs(abs(cosine) - 1) < _EPSILON:
        return q1 if fraction == 1.0 else q0
    angle = math.acos(min(max(cosine, -1.0), 1.0)) + spin * math.pi
    if abs(angle) < _EPSILON:
        return q0
    result: Quaternion = (
        q0 * math.sin((1 - fraction) * angle) + q1 * math.sin(fraction * angle)
    ) / math.sin(angle)
    return result


def random_rotation_matrix(rand: Any = None) -> Matrix:
    """Return a random rotation matrix. `rand` may give three numbers from 0 to 1."""
    return quaternion_matrix(random_quaternion(rand))


def random_quaternion(rand: Any = None) -> Quaternion:
    """Return a uniformly distributed rotation. `rand` may give three numbers from 0 to 1."""
    a, b, c = np.random.default_rng().random(3) if rand is None else np.asarray(rand, dtype=float)
    r1, r2 = math.sqrt(1 - a), math.sqrt(a)
    t1, t2 = 2 * math.pi * b, 2 * math.pi * c
    parts = [r1 * math.sin(t1), r1 * math.cos(t1), r2 * math.sin(t2), r2 * math.cos(t2)]
    return np.array(parts)


def is_same_transform(matrix0: Any, matrix1: Any) -> bool:
    """Return whether two matrices are the same transform."""
    return bool(np.allclose(np.asarray(matrix0), np.asarray(matrix1)))


def _axes(axes: str) -> tuple[int, int, int, int]:
    known = _AXES.get(axes.lower())
    if known is None:
        raise KeyError(f"axes {axes!r} are unknown: use one of {', '.join(_AXES)}")
    return known
