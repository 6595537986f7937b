"""Arcball of tf_transformations: rotation of an object by dragging with a pointer."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from zbot.tf2.transformations import (
    Matrix,
    Vector,
    quaternion_from_matrix,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
    unit_vector,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

_EPSILON = 1e-12


def arcball_map_to_sphere(point: Any, center: Any, radius: float) -> Vector:
    """Return the point of the unit sphere that is under a point of the window."""
    x, y = (point[0] - center[0]) / radius, (center[1] - point[1]) / radius
    distance = math.hypot(x, y)
    if distance > 1:
        return np.array([x / distance, y / distance, 0.0])
    return np.array([x, y, math.sqrt(1 - distance**2)])


def arcball_constrain_to_axis(point: Any, axis: Any) -> Vector:
    """Return the point nearest to `point` on the great circle at right angles to an axis."""
    along = np.asarray(axis, dtype=float)
    aside = np.asarray(point, dtype=float) - along * (along @ np.asarray(point, dtype=float))
    length = float(np.linalg.norm(aside))
    if length > _EPSILON:
        near: Vector = aside / length
        return -near if near[2] < 0 else near  # the half that faces the viewer
    if abs(along[2] - 1) < _EPSILON:
        return np.array([1.0, 0.0, 0.0])
    across: Vector = unit_vector([-along[1], along[0], 0.0])
    return across


def arcball_nearest_axis(point: Any, axes: Sequence[Any]) -> Any:
    """Return the axis whose great circle is nearest to a point."""
    where = np.asarray(point, dtype=float)
    return max(axes, key=lambda axis: float(arcball_constrain_to_axis(where, axis) @ where))


class Arcball:
    """Ball that a pointer rotates.

    Args:
        initial: The first orientation, as a quaternion or a 4 x 4 matrix.
    """

    def __init__(self, initial: Any = None) -> None:
        self._axes: list[Vector] | None = None
        self._axis: Any = None
        self._center: Vector = np.zeros(2)
        self._radius = 1.0
        self._grip = np.array([0.0, 0.0, 1.0])
        self._constrained = False
        given = [0.0, 0.0, 0.0, 1.0] if initial is None else initial
        is_matrix = np.shape(given) == (4, 4)
        first = quaternion_from_matrix(given) if is_matrix else unit_vector(given)
        self._down: Any = first
        self._now: Any = first
        self._before: Any = first

    def place(self, center: Any, radius: float) -> None:
        """Set the centre and the radius of the ball in the window, in pixels."""
        self._center, self._radius = np.asarray(center, dtype=float)[:2], float(radius)

    def setaxes(self, *axes: Any) -> None:
        """Set the axes for a constrained ball. Without arguments, any rotation is allowed."""
        self._axes = [unit_vector(axis) for axis in axes] or None

    def setconstrain(self, constrain: bool) -> None:
        """Set whether the ball rotates only about its axes."""
        self._constrained = constrain

    def getconstrain(self) -> bool:
        """Return whether the ball rotates only about its axes."""
        return self._constrained

    def down(self, point: Any) -> None:
        """Start to drag the ball at a point of the window."""
        self._grip = arcball_map_to_sphere(point, self._center, self._radius)
        self._down = self._before = self._now
        self._axis = None
        if self._constrained and self._axes is not None:
            self._axis = arcball_nearest_axis(self._grip, self._axes)
            self._grip = arcball_constrain_to_axis(self._grip, self._axis)

    def drag(self, point: Any) -> None:
        """Rotate the ball so that the point gripped by `down` is under a point of the window."""
        there = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            there = arcball_constrain_to_axis(there, self._axis)
        self._before = self._now
        across = np.cross(self._grip, there)
        if across @ across < _EPSILON:
            self._now = self._down
        else:
            turn = np.append(across, self._grip @ there)
            self._now = quaternion_multiply(turn, self._down)

    def next(self, acceleration: float = 0.0) -> None:
        """Continue the rotation of the last drag, faster by `acceleration`."""
        onward = quaternion_slerp(self._before, self._now, 2.0 + acceleration, shortestpath=False)
        self._before, self._now = self._now, onward

    def matrix(self) -> Matrix:
        """Return the orientation of the ball as a 4 x 4 matrix."""
        return quaternion_matrix(self._now)
