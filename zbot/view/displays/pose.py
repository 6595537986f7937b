"""Displays of poses: Pose, PoseArray, PoseWithCovariance and Odometry."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from zbot.view.colors import same
from zbot.view.displays.display import Display, Setting, item
from zbot.view.points import strip, thinned
from zbot.view.pose import pose_of
from zbot.view.shape import Arrows, Axes, Lines

if TYPE_CHECKING:
    from zbot.tf2.rigid import Rigid
    from zbot.view.mesh_file import MeshFiles
    from zbot.view.shape import Color, Shape

_RED = (240, 60, 40)
_VIOLET = (170, 70, 200)
_MOST_POSES = 5000
_LENGTH = Setting("length", 0.5, low=0.05, high=3.0, step=0.05)
_COLOR = Setting("color", _RED)
_SHAPE = Setting("shape", "arrow", ("arrow", "axes"))


def pose_shapes(poses: list[Rigid], way: str, length: float, color: Color) -> list[Shape]:
    """Return arrows along the x axes of poses, or their axes."""
    if way == "axes":
        return [Axes(tuple(poses), length)]
    ends = np.array([[pose.translation, pose.apply((length, 0, 0))] for pose in poses], np.float32)
    thick = length * 0.05
    colors = same(color, len(poses))
    return [Arrows(ends.reshape(-1, 2, 3), colors, thick, 2.5 * thick, 5 * thick)]


class Pose(Display):
    """Arrow or axes at a pose."""

    name = "Pose"
    types = ("geometry_msgs/msg/PoseStamped",)
    settings: ClassVar[tuple[Setting, ...]] = (_SHAPE, _LENGTH, _COLOR)

    def shapes(self, message: Any) -> list[Shape]:
        """Return the arrow or the axes of a pose."""
        return self._pose_shapes([pose_of(message.pose)])

    def _pose_shapes(self, poses: list[Rigid]) -> list[Shape]:
        way, length = str(self.values["shape"]), self.number("length")
        return pose_shapes(poses, way, length, self.color())


class PoseArray(Pose):
    """Arrows or axes at many poses, e.g. the particles of a localization."""

    name = "PoseArray"
    types = ("geometry_msgs/msg/PoseArray",)
    settings = (_SHAPE, Setting("length", 0.3, low=0.05, high=3.0, step=0.05), _COLOR)

    def shapes(self, message: Any) -> list[Shape]:
        """Return an arrow or axes for each pose."""
        if not message.poses:
            self.notice = "the message has no poses"
            return []
        poses = message.poses[thinned(len(message.poses), _MOST_POSES)]
        return self._pose_shapes([pose_of(pose) for pose in poses])


class ParticleCloud(PoseArray):
    """Poses of the particles of a localization, without their weights."""

    name = "ParticleCloud"
    types = ("nav2_msgs/msg/ParticleCloud",)

    def shapes(self, message: Any) -> list[Shape]:
        """Return an arrow or axes for each particle."""
        if not message.particles:
            self.notice = "the message has no particles"
            return []
        particles = message.particles[thinned(len(message.particles), _MOST_POSES)]
        return self._pose_shapes([pose_of(particle.pose) for particle in particles])


class PoseWithCovariance(Pose):
    """Pose with the ellipse of its uncertainty in the plane of x and y."""

    name = "PoseWithCovariance"
    types = ("geometry_msgs/msg/PoseWithCovarianceStamped",)
    settings: ClassVar[tuple[Setting, ...]] = (
        _SHAPE,
        _LENGTH,
        _COLOR,
        Setting("covariance", True),
    )

    def shapes(self, message: Any) -> list[Shape]:
        """Return the arrow or the axes of a pose, and an ellipse."""
        return self._uncertain_shapes(message.pose)

    def _uncertain_shapes(self, uncertain: Any) -> list[Shape]:
        pose = pose_of(uncertain.pose)
        shapes = self._pose_shapes([pose])
        if self.values["covariance"]:
            shapes += _ellipse(pose, np.asarray(uncertain.covariance, np.float64))
        return shapes


class Odometry(PoseWithCovariance):
    """Pose of a robot from odometry, with the line of the poses before it."""

    name = "Odometry"
    types = ("nav_msgs/msg/Odometry",)
    settings = (
        _SHAPE,
        _LENGTH,
        _COLOR,
        Setting("covariance", False),
        Setting("line", 500, low=0, high=5000, step=100),
    )

    def __init__(self, topic: str, files: MeshFiles | None = None) -> None:
        super().__init__(topic, files)
        self._line: list[tuple[float, float, float]] = []
        self._frame = ""

    def take(self, message: Any) -> None:
        """Show a pose, and add it to the line."""
        self.notice = ""
        shapes = self._uncertain_shapes(message.pose)
        if message.header.frame_id != self._frame:
            self._frame, self._line = message.header.frame_id, []
        place = pose_of(message.pose.pose).translation
        # A robot that stands still must not push the line out.
        if not self._line or math.dist(place, self._line[-1]) > 0.01:
            self._line.append(place)
        self._line = self._line[-int(self.number("line")) or len(self._line) :]
        if len(self._line) > 1:
            ends = strip(np.array(self._line, np.float32))
            shapes.append(Lines(ends, same(self.color(), len(ends), 2)))
        self.items = {"": item(message.header, shapes)}


def _ellipse(pose: Rigid, covariance: Any) -> list[Shape]:
    """Return the line around 95 % of the probable positions, in the plane of x and y."""
    if covariance.size != 36 or not np.isfinite(covariance).all():
        return []
    block = covariance.reshape(6, 6)[:2, :2]
    variances, directions = np.linalg.eigh((block + block.T) / 2)
    radii = np.sqrt(np.clip(variances, 0, 1e6) * 5.99)
    if not radii.any():
        return []
    turn = np.linspace(0, 2 * math.pi, 49)
    flat = directions @ (radii[:, None] * np.stack([np.cos(turn), np.sin(turn)]))
    x, y, z = pose.translation
    around = np.stack([flat[0] + x, flat[1] + y, np.full(len(turn), z)], axis=1)
    ends = strip(around.astype(np.float32))
    return [Lines(ends, same(_VIOLET, len(ends), 2))]
