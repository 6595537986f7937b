"""State of the robot, and its measures."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from zbot_nodes.robot.pose import Pose

PERIOD_S = 0.02
WHEEL_RADIUS_M = 0.05
WHEEL_DISTANCE_M = 0.3


class State(NamedTuple):
    """State of the robot after a period."""

    pose: Pose
    speed: float  #: m/s
    turn: float  #: rad/s
    wheels: tuple[float, float]  #: how far the left and the right wheel have turned, in radians
    is_blocked: bool  #: whether something is in the way
