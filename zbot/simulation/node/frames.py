"""Frames of a robot: from the world to the odometry, to the root, and to all links."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.libraries.robot_description.urdf import MOVING

from geometry_msgs.msg import TransformStamped

if TYPE_CHECKING:
    from zbot.libraries.robot_description.urdf import Joint
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.sensors.odometry import WheelOdometry
    from zbot.tf2.rigid import Rigid

#: Frame of the true poses.
WORLD_FRAME = "world"


class RobotFrames:
    """Transforms of one robot.

    Args:
        robot: The robot.
        prefix: The text before the names of its frames, e.g. `robot1/`.
        odometry_frame: The frame in which the wheels tell the pose.
        has_world: Whether the true pose of the odometry is told, too.
    """

    def __init__(self, robot: Robot, prefix: str, odometry_frame: str, *, has_world: bool) -> None:
        self._robot, self._prefix, self._has_world = robot, prefix, has_world
        self._odometry_frame = prefix + odometry_frame
        joints = robot.model.tree.joints
        self.is_silent = False  #: whether another program publishes the frames of the joints
        self._moving = {name: joints[name] for name in robot.joints}

    def fixed(self, stamp: Any) -> list[Any]:
        """Return the transforms of all joints that do not move."""
        joints = [] if self.is_silent else self._robot.model.tree.joints.values()
        return [self._of_joint(joint, 0.0, stamp) for joint in joints if joint.type not in MOVING]

    def of_joints(self, positions: dict[str, float], stamp: Any) -> list[Any]:
        """Return the transforms of all joints that move."""
        return [
            self._of_joint(joint, positions.get(name, 0.0), stamp)
            for name, joint in self._moving.items()
        ]

    def of_base(self, odometry: WheelOdometry | None, stamp: Any) -> list[Any]:
        """Return the pose of the root in the odometry, and that of the odometry in the world.

        A robot without odometry has only its true pose.
        """
        root = self._prefix + self._robot.model.tree.root
        if odometry is None:
            return [transform(WORLD_FRAME, root, self._robot.pose, stamp)]
        found = [transform(self._odometry_frame, root, odometry.pose, stamp)]
        if self._has_world:
            drift = self._robot.pose @ odometry.pose.inverse()
            found.append(transform(WORLD_FRAME, self._odometry_frame, drift, stamp))
        return found

    def _of_joint(self, joint: Joint, position: float, stamp: Any) -> Any:
        parent, child = self._prefix + joint.parent, self._prefix + joint.child
        return transform(parent, child, joint.transform(position), stamp)


def transform(parent: str, child: str, pose: Rigid, stamp: Any) -> Any:
    """Return the pose of a frame in another frame as a message."""
    message = TransformStamped(child_frame_id=child)
    message.header.stamp, message.header.frame_id = stamp, parent
    place, rotation = message.transform.translation, message.transform.rotation
    place.x, place.y, place.z = pose.translation
    rotation.x, rotation.y, rotation.z, rotation.w = pose.rotation
    return message
