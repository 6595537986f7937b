"""Path that a robot follows: how far it is, whether it is at the end, whether it gets ahead."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.path import length
from zbot_nodes.navigation.grids.rays import moved
from zbot_nodes.robot.pose import Pose, turn_to

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

_LAST_PART_M = 1.0
_WINDOW_M = 1.5  # the robot is not searched on parts of the path that are farther ahead


class FollowedPath:
    """Path of poses.

    Attributes:
        points: Its points.
        end: Its last pose.
        number: The number of the point that is nearest to the robot. It never falls.
    """

    def __init__(self, poses: Sequence[Pose]) -> None:
        self.points = np.array([pose[:2] for pose in poses], np.float64)
        self.end = poses[-1]
        self.number = 0
        steps = np.hypot(*np.diff(self.points, axis=0).T) if len(poses) > 1 else np.zeros(0)
        self._along = np.concatenate([[0.0], np.cumsum(steps)])

    def advance(self, pose: Pose) -> None:
        """Find the robot on the path."""
        near = self._along - self._along[self.number] <= _WINDOW_M
        near[: self.number] = False
        numbers = np.flatnonzero(near)
        away = np.hypot(*(self.points[numbers] - pose[:2]).T)
        self.number = int(numbers[away.argmin()])

    @property
    def left_m(self) -> float:
        """The length of the rest of the path."""
        return length(self.points[self.number :])

    def ahead_of(self, pose: Pose) -> NDArray[np.float64]:
        """Return the rest of the path in the frame of the robot."""
        return moved(self.points[self.number :], pose.inverse())


class GoalCheck:
    """Check whether the robot is at the end of its path.

    Attributes:
        is_there: Whether it is at the place. It may still have to turn.
    """

    def __init__(self, tolerance_m: float, tolerance_rad: float) -> None:
        self._tolerance_m, self._tolerance_rad = tolerance_m, tolerance_rad
        self.is_there = False

    def is_reached(self, path: FollowedPath, pose: Pose) -> bool:
        """Return whether the robot is at the end, and looks into its direction."""
        end = path.end
        away_m = math.hypot(end.x - pose.x, end.y - pose.y)
        # A path may pass its own end: only its last part counts.
        if away_m <= self._tolerance_m and path.left_m <= _LAST_PART_M + away_m:
            self.is_there = True
        elif away_m > 2 * self._tolerance_m:
            self.is_there = False
        return self.is_there and abs(turn_to(end.yaw - pose.yaw)) <= self._tolerance_rad


class ProgressCheck:
    """Check whether the robot moves.

    Args:
        least_m: The way that it must make.
        patience_s: The time in which it must make this way, or turn by half a radian.
    """

    def __init__(self, least_m: float, patience_s: float) -> None:
        self._least_m, self._patience_s = least_m, patience_s
        self._pose: Pose | None = None
        self._since_s = 0.0

    def is_stuck(self, pose: Pose, now_s: float) -> bool:
        """Return whether the robot has been at the same place for too long."""
        last = self._pose
        if (
            last is None
            or math.hypot(pose.x - last.x, pose.y - last.y) >= self._least_m
            or abs(turn_to(pose.yaw - last.yaw)) >= _LEAST_TURN
        ):
            self._pose, self._since_s = pose, now_s
            return False
        return now_s - self._since_s > self._patience_s


_LEAST_TURN = 0.5
