"""Trajectory of joints: positions at times, with curves between them."""

from __future__ import annotations

import math
from bisect import bisect_left
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from builtin_interfaces.msg import Duration, Time
    from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint


@dataclass(frozen=True)
class Point:
    """State of all joints at a time. Speeds and accelerations may be unknown."""

    time_s: float  #: since the start of the trajectory
    positions: tuple[float, ...]
    velocities: tuple[float, ...] | None = None
    accelerations: tuple[float, ...] | None = None


class Trajectory:
    """Points in the order of their times.

    Args:
        start: The state at the time when the trajectory was accepted.
        points: At least one point.
    """

    def __init__(self, start: Point, points: Sequence[Point]) -> None:
        self.points = [start, *points]
        self._times = [point.time_s for point in self.points]

    @property
    def end_s(self) -> float:
        """The time of the last point."""
        return self._times[-1]

    def sample(self, time_s: float, *, is_smooth: bool = True) -> Point:
        """Return the wanted state at a time. After the end, the joints rest at the last point.

        Args:
            time_s: Seconds since the start.
            is_smooth: If true, the states between two points lie on a curve. If false, the joints
                rest at the point before `time_s`.
        """
        last = self.points[-1]
        at_rest = (0.0,) * len(last.positions)
        if time_s >= last.time_s:
            return Point(time_s, last.positions, at_rest, at_rest)
        index = max(1, bisect_left(self._times, time_s))
        before, after = self.points[index - 1], self.points[index]
        if not is_smooth:
            return Point(time_s, before.positions, at_rest, at_rest)
        return _between(before, after, time_s)


def _between(before: Point, after: Point, time_s: float) -> Point:
    """Return a state between two points.

    It lies on a line, or on a polynomial of degree 3 or 5 if the points have speeds.
    """
    period_s = after.time_s - before.time_s
    share_s = min(max(time_s - before.time_s, 0.0), period_s)
    states = [
        _curve(_values(before, joint), _values(after, joint), period_s, share_s)
        for joint in range(len(after.positions))
    ]
    positions, velocities, accelerations = zip(*states, strict=True)
    return Point(time_s, positions, velocities, accelerations)


def _values(point: Point, joint: int) -> tuple[float, float | None, float | None]:
    velocity = None if point.velocities is None else point.velocities[joint]
    acceleration = None if point.accelerations is None else point.accelerations[joint]
    return point.positions[joint], velocity, acceleration


def _curve(
    a: tuple[float, float | None, float | None],
    b: tuple[float, float | None, float | None],
    period_s: float,
    t: float,
) -> tuple[float, float, float]:
    """Return position, velocity and acceleration of one joint at `t` seconds after `a`."""
    (p0, v0, a0), (p1, v1, a1) = a, b
    if period_s <= 0:
        return p1, v1 or 0.0, a1 or 0.0
    if v0 is None or v1 is None:
        speed = (p1 - p0) / period_s
        return p0 + speed * t, speed, 0.0
    way = p1 - p0
    if a0 is None or a1 is None:
        c2 = (3 * way - (2 * v0 + v1) * period_s) / period_s**2
        c3 = (-2 * way + (v0 + v1) * period_s) / period_s**3
        c4 = c5 = 0.0
    else:
        c2 = a0 / 2
        T = period_s  # noqa: N806 - as in the formula
        c3 = (20 * way - (8 * v1 + 12 * v0) * T - (3 * a0 - a1) * T**2) / (2 * T**3)
        c4 = (-30 * way + (14 * v1 + 16 * v0) * T + (3 * a0 - 2 * a1) * T**2) / (2 * T**4)
        c5 = (12 * way - 6 * (v1 + v0) * T + (a1 - a0) * T**2) / (2 * T**5)
    position = p0 + t * (v0 + t * (c2 + t * (c3 + t * (c4 + t * c5))))
    velocity = v0 + t * (2 * c2 + t * (3 * c3 + t * (4 * c4 + t * 5 * c5)))
    return position, velocity, 2 * c2 + t * (6 * c3 + t * (12 * c4 + t * 20 * c5))


def problem(
    message: JointTrajectory, joints: Sequence[str], *, may_be_partial: bool, may_move: bool
) -> str:
    """Return the reason why a trajectory is not valid for these joints, or an empty string.

    Args:
        message: The message.
        joints: The joints of the controller.
        may_be_partial: Whether the message may have only some of the joints.
        may_move: Whether the last point may have a speed.
    """
    names = list(message.joint_names)
    if not names:
        return "Empty joint names on incoming trajectory."
    if len(set(names)) < len(names) or not set(names) <= set(joints):
        return f"The joints {names} do not match the controller's joints {list(joints)}."
    if not may_be_partial and len(names) != len(joints):
        return f"Joints are missing: the controller has {list(joints)}."
    if not message.points:
        return "Empty trajectory received."
    before_s = -1.0
    for number, point in enumerate(message.points):
        time_s = seconds(point.time_from_start)
        if time_s <= before_s:
            return f"Time between points {number - 1} and {number} is not strictly increasing."
        before_s = time_s
        reason = _point_problem(point, number, names)
        if reason:
            return reason
    if not may_move and any(abs(velocity) > 1e-6 for velocity in message.points[-1].velocities):
        return "The velocity of the last trajectory point is not zero."
    return ""


def _point_problem(point: JointTrajectoryPoint, number: int, names: Sequence[str]) -> str:
    if not len(point.positions):
        return f"Point {number} has no positions."
    for kind in ("positions", "velocities", "accelerations"):
        values = getattr(point, kind)
        if len(values) not in {0, len(names)}:
            return f"Point {number} has {len(values)} {kind}, but there are {len(names)} joints."
        for name, value in zip(names, values, strict=False):
            if not math.isfinite(value):
                return f"Point {number} has {kind} that are not finite: {value} for joint '{name}'."
    return ""


def read_points(
    message: JointTrajectory, joints: Sequence[str], resting: Sequence[float]
) -> list[Point]:
    """Return the points of a valid message, in the order of the controller's joints.

    Args:
        message: The message.
        joints: The joints of the controller.
        resting: Positions of joints that the message does not have.
    """
    index = {name: number for number, name in enumerate(message.joint_names)}

    def ordered(values: Sequence[float], otherwise: Sequence[float]) -> tuple[float, ...]:
        return tuple(
            values[index[joint]] if joint in index else rest
            for joint, rest in zip(joints, otherwise, strict=True)
        )

    still = [0.0] * len(joints)
    return [
        Point(
            seconds(point.time_from_start),
            ordered(point.positions, resting),
            ordered(point.velocities, still) if len(point.velocities) else None,
            ordered(point.accelerations, still) if len(point.accelerations) else None,
        )
        for point in message.points
    ]


def seconds(duration: Duration | Time) -> float:
    """Return a message of type Duration or Time in seconds."""
    return float(duration.sec) + float(duration.nanosec) / 1e9
