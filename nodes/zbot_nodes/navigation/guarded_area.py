"""Area around a robot in which obstacles make it stop or drive slower."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from zbot_nodes.navigation.grids import np
from zbot_nodes.navigation.grids.footprint import corners_of
from zbot_nodes.navigation.grids.pursuit import Velocity, arc
from zbot_nodes.navigation.grids.rays import moved

from nav2_msgs.msg import CollisionMonitorState

if TYPE_CHECKING:
    from zbot_nodes.navigation.settings import Settings

    Floats = Any

_STATES = {
    "stop": CollisionMonitorState.STOP,
    "slowdown": CollisionMonitorState.SLOWDOWN,
    "approach": CollisionMonitorState.APPROACH,
    "limit": CollisionMonitorState.LIMIT,
}
_STEP_M = 0.02
_CORNERS_OF_CIRCLE = 16
_LEAST_CORNERS = 3


@dataclass(frozen=True)
class GuardedArea:
    """Area of one name, and what an obstacle in it does."""

    name: str
    corners: Floats  #: in the frame of the robot
    action: str  #: `stop`, `slowdown`, `limit` or `approach`
    least_points: int  #: fewer points are no obstacle
    share: float  #: how fast the robot still drives, for `slowdown`
    fastest: tuple[float, float]  #: m/s and rad/s, for `limit`
    time_s: float  #: the robot is so long before the obstacle, for `approach`

    @property
    def state(self) -> int:
        """What the area does, as a constant of CollisionMonitorState."""
        return _STATES[self.action]

    @classmethod
    def of(cls, settings: Settings, name: str) -> GuardedArea | None:
        """Return the area of the parameters of a name, or None if they do not describe one."""
        number, text = settings.number, settings.text
        corners = _corners(settings, name)
        action = text(f"{name}.action_type", "stop")
        if (
            corners is None
            or action not in _STATES
            or not settings.flag(f"{name}.enabled", default=True)
        ):
            return None
        limits = number(f"{name}.linear_limit", 0.5), number(f"{name}.angular_limit", 0.5)
        return cls(
            name,
            corners,
            action,
            int(number(f"{name}.min_points", 4)),
            number(f"{name}.slowdown_ratio", 0.5),
            limits,
            number(f"{name}.time_before_collision", 2.0),
        )

    def allowed_share(self, command: tuple[float, float, float], points: Floats) -> float:
        """Return with which share of a command the robot may drive.

        Args:
            command: The velocity forward and to the left in m/s, and the turn in rad/s.
            points: The points of obstacles, in the frame of the robot.
        """
        if self.action == "approach":
            return self._before_collision(command, points)
        if not self._has(points):
            return 1.0
        if self.action == "limit":
            speed, turn = math.hypot(*command[:2]), abs(command[2])
            return min(1.0, self.fastest[0] / max(speed, 1e-9), self.fastest[1] / max(turn, 1e-9))
        return 0.0 if self.action == "stop" else self.share

    def _before_collision(self, command: tuple[float, float, float], points: Floats) -> float:
        """Return the share with which the robot reaches the obstacle only after the time."""
        if self._has(points):
            return 1.0  # it is there already: nothing would be better than to drive away
        velocity = Velocity(command[0], command[2])
        poses = arc(velocity, self.time_s, _STEP_M)
        for number, pose in enumerate(poses):
            if self._has(moved(points, pose.inverse())):
                return number / len(poses)
        return 1.0

    def _has(self, points: Floats) -> bool:
        """Return whether enough points are in the area."""
        near = points[np.hypot(*points.T) <= np.hypot(*self.corners.T).max()]
        if len(near) < self.least_points:
            return False
        return int(_inside(self.corners, near).sum()) >= self.least_points


def _inside(corners: Floats, points: Floats) -> Floats:
    """Return which points are in a polygon: a ray to the right crosses its sides oddly often."""
    x, y = points.T
    is_inside = np.zeros(len(points), bool)
    for (x1, y1), (x2, y2) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        if y1 == y2:
            continue
        crosses = ((y1 > y) != (y2 > y)) & (x < x1 + (y - y1) * (x2 - x1) / (y2 - y1))
        is_inside ^= crosses
    return is_inside


def _corners(settings: Settings, name: str) -> Floats | None:
    if settings.text(f"{name}.type", "polygon") == "circle":
        radius = settings.number(f"{name}.radius", 0.0)
        angles = np.arange(_CORNERS_OF_CIRCLE) * (2 * math.pi / _CORNERS_OF_CIRCLE)
        circle = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return circle if radius > 0 else None
    points = settings.value(f"{name}.points", "")
    try:
        if isinstance(points, str):
            return corners_of(points)
        corners = np.array(list(points), np.float64).reshape(-1, 2)
    except ValueError:
        return None
    return corners if len(corners) >= _LEAST_CORNERS else None
