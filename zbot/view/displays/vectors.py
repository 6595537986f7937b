"""Displays of vectors: Wrench, Twist, Accel and PointStamped."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from zbot.view import solid
from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting
from zbot.view.pose import vector_of
from zbot.view.shape import Arrows, Mesh

if TYPE_CHECKING:
    from zbot.tf2.rigid import Vector
    from zbot.view.shape import Color, Shape

_STRAIGHT, _TURNING = (220, 60, 50), (210, 190, 30)
_VIOLET = (200, 40, 200)
_SCALE = Setting("scale", 1.0, low=0.05, high=5.0, step=0.05)


class Wrench(Display):
    """Force in red and torque in yellow, as arrows at the origin of the frame."""

    name = "Wrench"
    types = ("geometry_msgs/msg/WrenchStamped",)
    settings: ClassVar[tuple[Setting, ...]] = (
        _SCALE,
        Setting("color", _STRAIGHT),
        Setting("color of turning", _TURNING),
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the arrows of a force and a torque."""
        return self._pair(message.wrench.force, message.wrench.torque, "force and torque")

    def _pair(self, straight: Any, turning: Any, what: str) -> list[Shape]:
        arrows = [
            *self._arrow(vector_of(straight, what), self.color()),
            *self._arrow(vector_of(turning, what), self.color("color of turning")),
        ]
        if not arrows:
            self.notice = f"{what} are 0"
        return arrows

    def _arrow(self, vector: Vector, color: Color) -> list[Shape]:
        if not any(vector):
            return []
        ends = np.array([[(0, 0, 0), vector]], np.float32) * self.number("scale")
        thick = min(0.03, 0.08 * float(np.linalg.norm(ends)))
        return [Arrows(ends, same(color, 1), thick, 2.5 * thick, 5 * thick)]


class Twist(Wrench):
    """Velocity in red and angular velocity in yellow."""

    name = "Twist"
    types = ("geometry_msgs/msg/TwistStamped",)

    def shapes(self, message: Any) -> list[Shape]:
        """Return the arrows of two velocities."""
        return self._pair(message.twist.linear, message.twist.angular, "the velocities")


class Accel(Wrench):
    """Acceleration in red and angular acceleration in yellow."""

    name = "Accel"
    types = ("geometry_msgs/msg/AccelStamped",)

    def shapes(self, message: Any) -> list[Shape]:
        """Return the arrows of two accelerations."""
        return self._pair(message.accel.linear, message.accel.angular, "the accelerations")


class PointStamped(Display):
    """Small sphere at a point."""

    name = "PointStamped"
    types = ("geometry_msgs/msg/PointStamped",)
    settings = (
        Setting("radius", 0.1, low=0.01, high=1.0, step=0.01),
        Setting("color", _VIOLET),
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the sphere of a point."""
        vertices, faces = solid.sphere()
        place = np.array(vector_of(message.point, "the point"), np.float32)
        return [Mesh(vertices * 2 * self.number("radius") + place, faces, self.color())]
