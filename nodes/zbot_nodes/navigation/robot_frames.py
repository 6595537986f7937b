"""Poses between the frames of a robot, as transforms on /tf tell them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.tf2 import Buffer, TransformException, TransformListener
from zbot.tf2.rigid import Rigid
from zbot.time import Duration, Time
from zbot_nodes.robot.pose import Pose, to_quaternion, to_yaw

from geometry_msgs.msg import PoseStamped, TransformStamped

if TYPE_CHECKING:
    import zbot

_LATEST = Time()


class RobotFrames:
    """Frames that a node hears of.

    Args:
        node: The node, which subscribes.
    """

    def __init__(self, node: zbot.Node) -> None:
        self._node = node
        self._buffer = Buffer()
        self._listener = TransformListener(self._buffer, node)

    def pose(
        self, target: str, source: str, stamp: Any = _LATEST, *, wait_s: float = 0.0
    ) -> Pose | None:
        """Return the pose of a frame in another frame, or None if it is not known.

        Args:
            target: The frame of the result.
            source: The frame whose pose is wanted.
            stamp: The time. If left out, the latest one that is known.
            wait_s: How long to wait for it.
        """
        found = self.rigid(target, source, stamp, wait_s=wait_s)
        if found is None:
            return None
        x, y, z, w = found.rotation
        yaw = to_yaw(_quaternion(x, y, z, w))
        return Pose(found.translation[0], found.translation[1], yaw)

    def rigid(
        self, target: str, source: str, stamp: Any = _LATEST, *, wait_s: float = 0.0
    ) -> Rigid | None:
        """Return the same pose in space."""
        try:
            found = self._buffer.lookup_transform(
                target.lstrip("/"), source.lstrip("/"), stamp, Duration(seconds=wait_s)
            )
        except TransformException as error:
            self._node.get_logger().warning(
                f"no pose of {source} in {target}: {error}", throttle_duration_sec=5.0
            )
            return None
        place, turn = found.transform.translation, found.transform.rotation
        return Rigid((place.x, place.y, place.z), (turn.x, turn.y, turn.z, turn.w))

    def moved(self, message: Any, target: str) -> Pose | None:
        """Return the pose of a PoseStamped in a frame. Without a frame, it has this one."""
        pose = pose_in(message)
        source = message.header.frame_id
        if not source or source.lstrip("/") == target.lstrip("/"):
            return pose
        frame = self.pose(target, source)
        return None if frame is None else frame @ pose


def _quaternion(x: float, y: float, z: float, w: float) -> Any:
    rotation = to_quaternion(0.0)
    rotation.x, rotation.y, rotation.z, rotation.w = x, y, z, w
    return rotation


def pose_in(message: Any) -> Pose:
    """Return the pose in a PoseStamped."""
    place = message.pose.position
    return Pose(place.x, place.y, to_yaw(message.pose.orientation))


def pose_message(pose: Pose, frame: str, stamp: Any) -> Any:
    """Return a pose as PoseStamped."""
    message = PoseStamped()
    message.header.frame_id, message.header.stamp = frame, stamp
    message.pose.position.x, message.pose.position.y = pose.x, pose.y
    message.pose.orientation = to_quaternion(pose.yaw)
    return message


def transform_message(parent: str, child: str, pose: Pose, stamp: Any) -> Any:
    """Return the pose of a frame in another one as TransformStamped."""
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp = parent, stamp
    place = message.transform.translation
    place.x, place.y = pose.x, pose.y
    message.transform.rotation = to_quaternion(pose.yaw)
    return message
