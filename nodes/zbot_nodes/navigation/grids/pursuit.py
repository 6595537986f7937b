"""Pursuit of a path: the velocity that leads a robot to a point ahead on its path.

The robot drives an arc through a point of the path that is some way ahead. It drives slower in
narrow curves, near obstacles and before the goal, and turns on the spot if the path begins beside
or behind it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from zbot_nodes.robot.pose import Pose

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


class Velocity(NamedTuple):
    """Velocity of a robot."""

    forward: float = 0.0  #: m/s
    turn: float = 0.0  #: rad/s


@dataclass(frozen=True)
class PursuitRules:
    """How a robot follows a path."""

    speed: float = 0.5  #: m/s, on a straight path
    turn_speed: float = 1.8  #: rad/s, the fastest turn on the spot
    turn_acceleration: float = 3.2  #: rad/s²
    look_time_s: float = 1.5  #: how far ahead the point is, in time at the present speed
    nearest_look_m: float = 0.3
    farthest_look_m: float = 0.9
    turn_angle: float = 0.785  #: the robot turns on the spot if the point is more beside it
    narrow_radius_m: float = 0.9  #: in narrower curves, it drives slower
    slowest: float = 0.25  #: m/s, in curves and near obstacles
    approach_m: float = 0.6  #: it drives slower when the goal is nearer
    approach_slowest: float = 0.05  #: m/s, at the goal

    def follow(self, points: Floats, last: Velocity, period_s: float) -> Velocity:
        """Return the velocity along a path.

        Args:
            points: The rest of the path, in the frame of the robot.
            last: The last velocity.
            period_s: The time since then.
        """
        look_m = min(
            max(abs(last.forward) * self.look_time_s, self.nearest_look_m), self.farthest_look_m
        )
        x, y = ahead(points, look_m)
        angle = math.atan2(y, x)
        # A robot that turns goes on until it looks along the path, otherwise it would start again.
        is_turning = abs(last.forward) < 1e-3 and abs(last.turn) > 1e-3
        if abs(angle) > (0.3 * self.turn_angle if is_turning else self.turn_angle):
            return self.turn(angle, last, period_s)
        bend = 2 * y / max(x * x + y * y, 1e-6)
        speed = self.speed
        if abs(bend) * self.narrow_radius_m > 1:
            speed = max(speed / (abs(bend) * self.narrow_radius_m), min(self.slowest, speed))
        left_m = math.hypot(*points[-1])
        if left_m < self.approach_m:
            speed = max(min(speed, self.speed * left_m / self.approach_m), self.approach_slowest)
        turn = max(-self.turn_speed, min(self.turn_speed, speed * bend))
        return Velocity(speed, turn)

    def turn(self, angle: float, last: Velocity, period_s: float) -> Velocity:
        """Return the velocity that turns the robot on the spot by an angle."""
        # With this speed, the robot can still stop at the angle.
        stopping = math.sqrt(2 * self.turn_acceleration * abs(angle)) * 0.7
        wanted = math.copysign(min(self.turn_speed, stopping), angle)
        change = self.turn_acceleration * period_s
        return Velocity(0.0, last.turn + max(-change, min(change, wanted - last.turn)))


def ahead(points: Floats, look_m: float) -> tuple[float, float]:
    """Return the point of a path that is a distance away from the robot, or the path's end."""
    away = np.hypot(points[:, 0], points[:, 1])
    beyond = np.flatnonzero(away >= look_m)
    if not len(beyond):
        return float(points[-1, 0]), float(points[-1, 1])
    number = int(beyond[0])
    if number == 0:
        return float(points[0, 0]), float(points[0, 1])
    near, far = away[number - 1], away[number]
    share = (look_m - near) / max(far - near, 1e-9)
    x, y = points[number - 1] + share * (points[number] - points[number - 1])
    return float(x), float(y)


def arc(velocity: Velocity, duration_s: float, step_m: float) -> list[Pose]:
    """Return the poses of a robot that keeps a velocity, in its present frame."""
    way = max(abs(velocity.forward), abs(velocity.turn) * 0.2) * duration_s
    count = max(1, math.ceil(way / max(step_m, 1e-3)))
    pose, poses = Pose(), []
    part = duration_s / count
    step = _chord(velocity, part)
    for _ in range(count):
        pose = pose @ step
        poses.append(pose)
    return poses


def _chord(velocity: Velocity, duration_s: float) -> Pose:
    half = velocity.turn * duration_s / 2
    way = velocity.forward * duration_s * (math.sin(half) / half if abs(half) > 1e-9 else 1.0)
    return Pose(way * math.cos(half), way * math.sin(half), 2 * half)
