"""Publish the frames of a robot from its description and from the positions of its joints.

Run:        zbot run robot_state_publisher robot_state_publisher robot.urdf
            in launch files: parameters=[{"robot_description": Command(["xacro ", path])}]
Subscribes: joint_states (sensor_msgs/JointState)
Publishes:  tf (tf2_msgs/TFMessage) for joints that move, tf_static (tf2_msgs/TFMessage) for fixed
            joints, robot_description (std_msgs/String), kept for late subscribers
Parameters: robot_description (string): URDF or SDF. publish_frequency (double, 20.0 Hz, 0 to
            1000): the highest rate of a joint's frame. frame_prefix (string, ""): text before each
            frame. ignore_timestamp (bool, false): accept joint states of any time stamp
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from zbot.errors import ZbotError, require_numpy
from zbot.libraries.robot_description.urdf import MOVING, Robot, read_urdf
from zbot.libraries.robot_description.xml_text import DescriptionError, read_xml
from zbot.parameters.qos_overrides import QoSOverridingOptions
from zbot.parameters.ros_args import remove_ros_args
from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from zbot.tf2 import StaticTransformBroadcaster, TransformBroadcaster
from zbot_nodes.startup.program import run_node

from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import SetParametersResult
from sensor_msgs.msg import JointState
from std_msgs.msg import String

if TYPE_CHECKING:
    from zbot.tf2.rigid import Rigid

    from builtin_interfaces.msg import Time

_MAX_RATE_HZ = 1000.0
_DESCRIPTION, _RATE = "robot_description", "publish_frequency"


class RobotStatePublisher(zbot.Node):
    """Publishes the frame of every link.

    Args:
        path: A URDF file. It is read if the parameter robot_description is empty.
        options: The options of `zbot.Node`.
    """

    def __init__(self, path: str = "", **options: Any) -> None:
        super().__init__("robot_state_publisher", **options)
        text = str(self.declare_parameter(_DESCRIPTION, "").value)
        if not text:
            text = read_file(path)
            self.set_parameters([zbot.Parameter(_DESCRIPTION, value=text)])
        self.declare_parameter(_RATE, 20.0)
        self.declare_parameter("frame_prefix", "")
        self.declare_parameter("ignore_timestamp", False)
        reason = self.problem(_RATE, self.get_parameter(_RATE).value)
        if reason:
            raise DescriptionError(reason)
        self.robot = read_robot(text)
        self.published: dict[str, int] = {}  #: by joint: the stamp that was published last, in ns
        self.last_callback_ns = 0
        self.broadcaster = TransformBroadcaster(self)
        self.static_broadcaster = StaticTransformBroadcaster(self)
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.description_publisher = self.create_publisher(String, _DESCRIPTION, kept)
        self.use(text, self.robot)
        self.create_subscription(
            JointState,
            "joint_states",
            self.accept,
            qos_profile_sensor_data,
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )
        self.add_on_set_parameters_callback(self.check)
        self.add_post_set_parameters_callback(self.apply)

    def use(self, text: str, robot: Robot) -> None:
        """Publish a description and its fixed frames."""
        self.robot = robot
        self.description_publisher.publish(String(data=text))
        stamp = self.get_clock().now().to_msg()
        fixed = (joint for joint in robot.joints.values() if joint.type not in MOVING)
        self.static_broadcaster.sendTransform(
            [
                self.frame(joint.parent, joint.child, joint.transform(), stamp)
                for joint in fixed
                if joint.type != "floating"  # another node publishes the pose of such a joint
            ]
        )
        self.get_logger().info("Robot initialized")

    def accept(self, state: JointState) -> None:
        """Publish the frames of the joints in a message, if the message is new enough."""
        if len(state.name) != len(state.position):
            self.refuse(state)
            return
        now_ns = self.get_clock().now().nanoseconds
        if now_ns < self.last_callback_ns:
            self.get_logger().warn("Moved backwards in time, re-publishing joint transforms!")
            self.published.clear()
        self.last_callback_ns = now_ns
        stamp_ns = zbot.Time.from_msg(state.header.stamp).nanoseconds
        last_ns = min((now_ns, *(self.published.get(name, 0) for name in state.name)))
        if self.get_parameter("ignore_timestamp").value or stamp_ns >= last_ns + self.interval_ns():
            self.publish_joints(dict(zip(state.name, state.position, strict=True)), state)
            self.published.update(dict.fromkeys(state.name, stamp_ns))
        elif stamp_ns == 0:
            self.get_logger().warn(
                "joint_states without a time stamp are ignored: set header.stamp, or the parameter "
                "ignore_timestamp",
                throttle_duration_sec=10.0,
            )

    def refuse(self, state: JointState) -> None:
        """Log why a message is ignored."""
        if not state.position:
            self.get_logger().warn(
                "Robot state publisher ignored a JointState message about joint(s) "
                f'"{state.name[0]}"(,...) whose position member was empty.'
            )
        else:
            self.get_logger().error("Robot state publisher ignored an invalid JointState message")

    def interval_ns(self) -> int:
        """Return the shortest time between two frames of a joint. A rate of 0 Hz has no limit."""
        rate_hz = float(self.get_parameter(_RATE).value)
        return int(1000 / rate_hz) * 1_000_000 if rate_hz else 0

    def publish_joints(self, positions: dict[str, float], state: JointState) -> None:
        """Publish the frames of these joints, and of the joints that mimic them."""
        joints = self.robot.joints
        for joint in joints.values():
            mimic = joint.mimic
            if mimic is not None and mimic.joint in positions:
                value = positions[mimic.joint] * mimic.multiplier + mimic.offset
                positions.setdefault(joint.name, value)
        moved = [joints[name] for name in positions if name in joints]
        self.broadcaster.sendTransform(
            [
                self.frame(
                    joint.parent,
                    joint.child,
                    joint.transform(positions[joint.name]),
                    state.header.stamp,
                )
                for joint in moved
                if joint.type in MOVING
            ]
        )

    def frame(self, parent: str, child: str, pose: Rigid, stamp: Time) -> TransformStamped:
        """Return the message of one frame."""
        prefix = self.get_parameter("frame_prefix").value
        message = TransformStamped(child_frame_id=f"{prefix}{child}")
        message.header.frame_id = f"{prefix}{parent}"
        message.header.stamp = stamp
        t, q = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = pose.translation
        q.x, q.y, q.z, q.w = pose.rotation
        return message

    def check(self, parameters: list[zbot.Parameter[Any]]) -> SetParametersResult:
        """Refuse parameters that cannot be used."""
        reasons = (self.problem(parameter.name, parameter.value) for parameter in parameters)
        reason = next(filter(None, reasons), "")
        return SetParametersResult(successful=not reason, reason=reason)

    def problem(self, name: str, value: object) -> str:
        """Return the reason why a parameter cannot have a value, or an empty string."""
        if name == _RATE and isinstance(value, float) and not 0.0 <= value <= _MAX_RATE_HZ:
            return "publish_frequency must be between 0.0 and 1000.0"
        if name == _DESCRIPTION and isinstance(value, str):
            if not value:
                return "Empty URDF is not allowed"
            try:
                read_robot(value)
            except ZbotError as error:
                return str(error)
        return ""

    def apply(self, parameters: list[zbot.Parameter[Any]]) -> None:
        """Use a new description."""
        for parameter in parameters:
            if parameter.name == _DESCRIPTION and isinstance(parameter.value, str):
                self.use(parameter.value, read_robot(parameter.value))


def read_robot(text: str) -> Robot:
    """Return the links and joints of a description in URDF or SDF."""
    if not text.strip() or read_xml(text).tag != "sdf":
        return read_urdf(text)
    require_numpy("a robot description in SDF")
    from zbot.simulation.sdf.robot import tree_of  # noqa: PLC0415 - with NumPy

    return tree_of(text)


def read_file(path: str) -> str:
    """Return the text of the URDF file of the command line."""
    if not path:
        raise DescriptionError("the parameter robot_description must not be empty")
    try:
        return Path(path).read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise DescriptionError(f"cannot read '{path}': {os.strerror(error.errno or 0)}") from None


def main() -> None:
    """Run until Ctrl-C."""
    paths = remove_ros_args()[1:]
    run_node(lambda: RobotStatePublisher(paths[0] if paths else ""))


if __name__ == "__main__":
    main()
