"""Rigid transforms: a translation in metres and a rotation as a quaternion x y z w."""

from __future__ import annotations

import math
from typing import NamedTuple

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

_NEARLY_PARALLEL = 0.9995  # a cosine; above this value, the sine of the angle is too close to 0


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the rotation that applies `b` and then `a`."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """Return the inverse rotation."""
    return (-q[0], -q[1], -q[2], q[3])


def normalized(q: Quaternion) -> Quaternion:
    """Return a quaternion of length 1.

    Raises:
        ZeroDivisionError: The length of the quaternion is 0.
    """
    length = math.sqrt(sum(part * part for part in q))
    x, y, z, w = q
    return (x / length, y / length, z / length, w / length)


def rotate(q: Quaternion, v: Vector) -> Vector:
    """Return the rotated vector."""
    x, y, z, _ = multiply(multiply(q, (*v, 0.0)), conjugate(q))
    return (x, y, z)


def heading(q: Quaternion) -> float:
    """Return the part of a rotation that is about the z axis, in radians from -pi to pi."""
    x, y, z, w = q
    return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def slerp(a: Quaternion, b: Quaternion, share: float) -> Quaternion:
    """Return a rotation on the shorter way from `a` (`share` is 0) to `b` (`share` is 1)."""
    cosine = sum(p * q for p, q in zip(a, b, strict=True))
    if cosine < 0:
        b = (-b[0], -b[1], -b[2], -b[3])
        cosine = -cosine
    if cosine > _NEARLY_PARALLEL:
        weights = (1 - share, share)
    else:
        angle = math.acos(cosine)
        weights = (math.sin((1 - share) * angle), math.sin(share * angle))
    x, y, z, w = (weights[0] * p + weights[1] * q for p, q in zip(a, b, strict=True))
    return normalized((x, y, z, w))


class Rigid(NamedTuple):
    """Transform of a child frame in its parent. It maps the child's coordinates to the parent."""

    translation: Vector = (0.0, 0.0, 0.0)
    rotation: Quaternion = (0.0, 0.0, 0.0, 1.0)

    def __matmul__(self, inner: Rigid) -> Rigid:
        """Return the transform that applies `inner` and then this one."""
        return Rigid(self.apply(inner.translation), multiply(self.rotation, inner.rotation))

    def apply(self, point: Vector) -> Vector:
        """Return a point's coordinates in the parent."""
        x, y, z = rotate(self.rotation, point)
        tx, ty, tz = self.translation
        return (x + tx, y + ty, z + tz)

    def inverse(self) -> Rigid:
        """Return the inverse transform."""
        back = conjugate(self.rotation)
        x, y, z = rotate(back, self.translation)
        return Rigid((-x, -y, -z), back)

    def towards(self, other: Rigid, share: float) -> Rigid:
        """Return a transform between this transform (`share` is 0) and `other` (`share` is 1)."""
        x, y, z = (
            p + share * (q - p) for p, q in zip(self.translation, other.translation, strict=True)
        )
        return Rigid((x, y, z), slerp(self.rotation, other.rotation, share))
