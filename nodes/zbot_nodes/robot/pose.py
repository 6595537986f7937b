"""Pose of the robot, and its conversion from and to messages."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from zbot.tf2.rigid import heading

from geometry_msgs.msg import Quaternion

if TYPE_CHECKING:
    from nav_msgs.msg import Odometry

#: Topic with the true pose, for the simulated sensors. Real sensors need no such topic, so lists
#: and graphs do not show it. The `_` at the beginning of its name hides it.
TRUTH = "_ground_truth"


class Pose(NamedTuple):
    """Position on the floor and heading."""

    x: float = 0.0  #: metres
    y: float = 0.0  #: metres
    yaw: float = 0.0  #: radians, counter-clockwise from the x axis

    def __matmul__(self, inner: Pose) -> Pose:
        """Return a pose in this pose's parent. `inner` is that pose in the frame of this one."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x, y, yaw = inner
        return Pose(self.x + x * cos - y * sin, self.y + x * sin + y * cos, turn_to(self.yaw + yaw))

    def inverse(self) -> Pose:
        """Return the pose of the parent in the frame of this pose."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Pose(-self.x * cos - self.y * sin, self.x * sin - self.y * cos, -self.yaw)


def pose_of(msg: Odometry) -> Pose:
    """Return the pose in an odometry message."""
    position = msg.pose.pose.position
    return Pose(position.x, position.y, to_yaw(msg.pose.pose.orientation))


def to_quaternion(yaw: float) -> Quaternion:
    """Return a rotation about the vertical axis as a quaternion."""
    return Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2))


def to_yaw(q: Quaternion) -> float:
    """Return a quaternion's rotation about the vertical axis, from -pi to pi."""
    return heading((q.x, q.y, q.z, q.w))


def turn_to(angle: float) -> float:
    """Return the angle from -pi to pi that has the same direction: the shorter way to turn."""
    return math.atan2(math.sin(angle), math.cos(angle))
