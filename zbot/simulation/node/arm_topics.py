"""Topics that move an arm: those of ROS 2's controllers for trajectories and for positions."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from std_msgs.msg import Float64MultiArray
from trajectory_msgs.msg import JointTrajectory

if TYPE_CHECKING:
    from collections.abc import Sequence

    from zbot.node.node import Node
    from zbot.simulation.robots.arm import ArmMotors

_MOST_POINTS = 10_000


class ArmTopics:
    """Topics of one arm.

    Args:
        node: The node that subscribes.
        motors: The motors of the arm.
        start: The text before the names of the topics, e.g. `/robot1/`.
    """

    def __init__(self, node: Node, motors: ArmMotors, start: str) -> None:
        self._node, self._motors = node, motors
        name = f"{start}arm_controller"
        self._subscriptions: list[Any] = [
            node.create_subscription(JointTrajectory, f"{name}/joint_trajectory", self.follow, 10),
            node.create_subscription(Float64MultiArray, f"{name}/commands", self.go, 10),
        ]

    def go(self, message: Any) -> None:
        """Go to the positions of all joints, in the order of `/joint_states`."""
        if len(message.data) != len(self._motors.names):
            self._refuse(f"it has {len(message.data)} numbers, not {len(self._motors.names)}")
        elif not _are_finite(message.data):
            self._refuse("a position is not finite")
        else:
            self._motors.go(message.data)

    def follow(self, message: Any) -> None:
        """Follow a trajectory. Joints that it does not name stay where they shall be."""
        unknown = [name for name in message.joint_names if name not in self._motors.names]
        if unknown:
            self._refuse(f"there is no joint '{unknown[0][:100]}'")
            return
        if len(message.points) > _MOST_POINTS:
            self._refuse(f"it has {len(message.points)} points: the limit is {_MOST_POINTS}")
            return
        places = [self._motors.names.index(name) for name in message.joint_names]
        way: list[tuple[float, list[float]]] = []
        for point in message.points:
            at_s = point.time_from_start.sec + point.time_from_start.nanosec / 1e9
            is_whole = len(point.positions) == len(places) and _are_finite(point.positions)
            if not is_whole or at_s <= (way[-1][0] if way else 0.0):
                self._refuse("each point needs a position for each joint, and a later time")
                return
            positions = self._motors.wanted.tolist()
            for place, value in zip(places, point.positions, strict=True):
                positions[place] = value
            way.append((at_s, positions))
        if way:
            self._motors.follow(way)

    def _refuse(self, reason: str) -> None:
        self._node.get_logger().warning(
            f"A command for the arm is ignored: {reason}", throttle_duration_sec=5.0
        )

    def release(self) -> None:
        """Leave the topics."""
        for subscription in self._subscriptions:
            self._node.destroy_subscription(subscription)


def _are_finite(values: Sequence[float]) -> bool:
    return all(map(math.isfinite, values))
