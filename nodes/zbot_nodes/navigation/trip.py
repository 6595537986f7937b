"""Trip of a robot to its goals: what is still to do, and what was done."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from zbot.time import Duration
from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.path import length, nearest
from zbot_nodes.navigation.robot_frames import pose_in

if TYPE_CHECKING:
    from zbot_nodes.navigation.remote_actions import RunningGoal
    from zbot_nodes.robot.pose import Pose

_PASSED_M = 0.7  # a goal on the way counts as passed when the robot is so near
_USUAL_SPEED = 0.3  # m/s, before the robot has driven


@dataclass
class Trip:
    """Trip to one or more goals."""

    goals: list[Any]  #: poses with their frames, in their order
    begin_s: float
    path: Any = None  #: the last plan
    following: RunningGoal | None = None  #: the goal of the controller
    planned_s: float = -math.inf
    recoveries: int = 0
    passed: int = 0  #: the number of goals that were passed
    way_m: float = 0.0
    _last: Pose | None = field(default=None, repr=False)

    def move(self, pose: Pose, goals: list[Pose | None]) -> None:
        """Note where the robot is.

        Args:
            pose: Its pose in the map.
            goals: The poses of the goals in the map.
        """
        if self._last is not None:
            self.way_m += math.hypot(pose.x - self._last.x, pose.y - self._last.y)
        self._last = pose
        for goal in goals[:-1]:
            if goal is None or math.hypot(goal.x - pose.x, goal.y - pose.y) > _PASSED_M:
                break
            del self.goals[0]
            self.passed += 1
            self.planned_s = -math.inf

    def left_m(self) -> float:
        """Return the length of the rest of the path."""
        if self.path is None or self._last is None:
            return 0.0
        points = np.array([pose_in(pose)[:2] for pose in self.path.poses])
        return length(points[nearest(points, self._last.x, self._last.y) :])

    def fill(self, feedback: Any, now_s: float) -> None:
        """Write the feedback of both actions."""
        passed_s, left_m = now_s - self.begin_s, self.left_m()
        speed = self.way_m / passed_s if self.way_m > 1 and passed_s > 0 else _USUAL_SPEED
        feedback.navigation_time = Duration(seconds=passed_s).to_msg()
        feedback.estimated_time_remaining = Duration(seconds=left_m / max(speed, 0.05)).to_msg()
        feedback.number_of_recoveries = self.recoveries
        feedback.distance_remaining = left_m
