"""Publish goals for a joint trajectory controller.

Run:        zbot run ros2_controllers_test_nodes publisher_joint_trajectory_controller
            --ros-args --params-file goals.yaml
Publishes:  /CONTROLLER/joint_trajectory (trajectory_msgs/JointTrajectory)
Subscribes: joint_states (sensor_msgs/JointState), with check_starting_point
Parameters: controller_name (position_trajectory_controller), wait_sec_between_publish (6),
            joints, goal_names, GOAL.positions, GOAL.velocities, GOAL.accelerations, GOAL.effort,
            check_starting_point (false), starting_point_limits.JOINT: lowest and highest position
"""

from __future__ import annotations

import math
from typing import Any

from zbot_nodes.control.goal_publisher import GoalPublisher
from zbot_nodes.startup.program import ParameterError, run_node

from builtin_interfaces.msg import Duration
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

_GOAL_TIME_S = 4
_FIELDS = ("positions", "velocities", "accelerations", "effort")


class JointTrajectoryPublisher(GoalPublisher):
    """Publishes a trajectory to one goal after the other."""

    period_s = 6

    def __init__(self, **options: Any) -> None:
        super().__init__("publisher_position_trajectory_controller", **options)
        self.is_checking = bool(self.read("check_starting_point", False))
        self.start: JointState | None = None
        if self.is_checking:
            self.limits = {joint: self.limit(joint) for joint in self.joints()}
            self.create_subscription(JointState, "joint_states", self.accept, 10)

    def joints(self) -> list[str]:
        """Return the names of the joints."""
        names = [str(joint) for joint in self.read("joints") or [] if joint]
        if not names:
            raise ParameterError("the parameter joints is empty")
        return names

    def limit(self, joint: str) -> list[float]:
        """Return the lowest and the highest position of a joint at the start."""
        name = f"starting_point_limits.{joint}"
        found = self.numbers(name) or [-math.tau, math.tau]
        if len(found) != 2:
            raise ParameterError(f"the parameter {name} must be two numbers")
        return found

    def topic(self) -> str:
        """Return the name of the topic."""
        name = str(self.read("controller_name", "position_trajectory_controller"))
        return f"/{name.strip('/')}/joint_trajectory"

    def message(self, goal: str) -> JointTrajectory:
        """Return a trajectory with one point: the goal."""
        names, point = self.joints(), JointTrajectoryPoint()
        point.time_from_start = Duration(sec=_GOAL_TIME_S)
        found = {field: self.numbers(f"{goal}.{field}") for field in _FIELDS}
        for field, values in found.items():
            if values and len(values) != len(names):
                raise ParameterError(
                    f"the parameter {goal}.{field} must have {len(names)} numbers, as many as "
                    "joints"
                )
            setattr(point, field, values)
        if not any(found.values()):
            raise ParameterError(f"the parameter {goal}.positions is empty")
        return JointTrajectory(joint_names=names, points=[point])

    def accept(self, message: JointState) -> None:
        """Store the first positions."""
        self.start = self.start or message

    def publish(self) -> None:
        """Publish the next goal, unless the robot did not start between the limits."""
        if not self.is_checking:
            super().publish()
        elif self.start is None:
            self.get_logger().warn("The positions at the start are unknown: no joint_states came")
        elif outside := self.outside(self.start):
            self.get_logger().warn(f"At the start, joints were outside their limits: {outside}")
        else:
            super().publish()

    def outside(self, message: JointState) -> str:
        """Return the joints that are outside their limits."""
        found = zip(message.name, message.position, strict=False)
        return ", ".join(
            joint
            for joint, position in found
            if joint in self.limits
            and not self.limits[joint][0] <= position <= self.limits[joint][1]
        )


def main() -> None:
    """Run until Ctrl-C."""
    run_node(JointTrajectoryPublisher)


if __name__ == "__main__":
    main()
