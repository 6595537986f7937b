"""Topics of one robot: its commands, its odometry, its joints, its frames and its sensors."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from zbot.graph.snapshot import Snapshot
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot.simulation.node.arm_topics import ArmTopics
from zbot.simulation.node.frames import WORLD_FRAME, RobotFrames
from zbot.simulation.node.schedule import Schedule
from zbot.simulation.node.sensor_kinds import KINDS
from zbot.simulation.node.sensor_topics import Mount, SensorTopic
from zbot.simulation.sensors.odometry import WheelOdometry

from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.simulation.robots.equipment import Drive
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World
    from zbot.tf2.rigid import Rigid

_RATE_HZ = 50.0
#: A robot stops if no command has come for this time in the world.
COMMAND_LASTS_S = 0.5
#: Commands above this are cut, in m/s and rad/s.
_FASTEST = 50.0
_LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


class RobotTopics:
    """Topics of one robot.

    Args:
        node: The node that publishes.
        world: The world of the robot.
        robot: The robot.
        namespace: The namespace of its topics, which is also the text before its frames. Empty
            means none.
        has_world: Whether the transform from the world to its odometry is published.
    """

    def __init__(
        self, node: Node, world: World, robot: Robot, namespace: str, *, has_world: bool = True
    ) -> None:
        self.node, self.world, self.robot, self.namespace = node, world, robot, namespace
        self.start = f"/{namespace}/" if namespace else "/"
        self.prefix = f"{namespace}/" if namespace else ""
        drive = self.drive = robot.model.equipment.drive
        self.odometry = None if drive is None else WheelOdometry(robot)
        odometry_frame = "odom" if drive is None else drive.odometry_frame
        self.frames = RobotFrames(robot, self.prefix, odometry_frame, has_world=has_world)
        self._made: list[Any] = []
        self._commands: Any = None
        self._last_command_ns = 0
        self._stamp: Any = None
        self._publishers()
        self._sensors = self._new_sensors()
        self._arm = None if robot.arm is None else ArmTopics(node, robot.arm, self.start)
        rate_hz = _RATE_HZ if drive is None else drive.rate_hz
        self.schedules = [
            Schedule(rate_hz, self._publish_motion),
            *(Schedule(topic.rate_hz, topic.run) for topic in self._sensors),
        ]
        self.follow_commands()

    def _publishers(self) -> None:
        node, start = self.node, self.start
        self._joints = self._keep(node.create_publisher(JointState, f"{start}joint_states", 10))
        self._tf = self._keep(node.create_publisher(TFMessage, "/tf", 100))
        self._truth = self._keep(node.create_publisher(Odometry, f"{start}ground_truth", 10))
        self._odom = None
        if self.drive is not None:
            topic = start + self.drive.odometry_topic.lstrip("/")
            self._odom = self._keep(node.create_publisher(Odometry, topic, 10))
        description = self._keep(
            node.create_publisher(String, f"{start}robot_description", _LATCHED)
        )
        description.publish(String(data=prefixed(self.robot.model.text, self.prefix)))

    def _keep(self, publisher: Any) -> Any:
        self._made.append(publisher)
        return publisher

    def _new_sensors(self) -> list[_Timed]:
        found = []
        for number, sensor in enumerate(self.robot.model.equipment.sensors):
            mount = Mount(self.robot, self.start, self.prefix, number)
            topic = KINDS[type(sensor)](self.node, sensor, mount)
            found.append(_Timed(topic, sensor.rate_hz, self.world))
        return found

    def follow_commands(self) -> None:
        """Subscribe to commands, in the type that their publisher has: Twist or TwistStamped."""
        if self.drive is None:
            return
        topic = self.start + self.drive.command_topic.lstrip("/")
        types = {
            token.type_name for token in Snapshot(self.node.context.graph.known()).publishers(topic)
        }
        stamped = types == {"geometry_msgs/msg/TwistStamped"}
        wanted = TwistStamped if stamped else Twist
        if self._commands is not None:
            if not types or self._commands.msg_type is wanted:
                return
            self.node.destroy_subscription(self._commands)
        take = self._take_stamped if stamped else self.take
        self._commands = self.node.create_subscription(wanted, topic, take, 10)

    def _take_stamped(self, message: Any) -> None:
        self.take(message.twist)

    def take(self, twist: Any) -> None:
        """Use a command, unless a number is not finite."""
        command = (twist.linear.x, twist.linear.y, twist.angular.z)
        if not all(math.isfinite(value) for value in command):
            self.node.get_logger().warning(
                f"{self.robot.name} ignores a command that is not finite", once=True
            )
            return
        forward, left, turn = (max(-_FASTEST, min(_FASTEST, value)) for value in command)
        self.robot.command = (forward, left, turn)
        self._last_command_ns = self.world.time_ns

    def run(self, stamp: Any, now_ns: int) -> None:
        """Publish what is due."""
        self._stamp = stamp
        if now_ns - self._last_command_ns > COMMAND_LASTS_S * 1e9:
            self.robot.command = (0.0, 0.0, 0.0)
        for sensor in self._sensors:
            sensor.stamp = stamp
        for schedule in self.schedules:
            schedule.run(now_ns)

    def reset(self) -> None:
        """Begin again after a reset of the world."""
        self._last_command_ns = 0
        if self.odometry is not None:
            self.odometry.reset()
        for schedule in self.schedules:
            schedule.reset()

    def release(self) -> None:
        """Destroy all topics."""
        for sensor in self._sensors:
            sensor.topic.release()
        for publisher in self._made:
            self.node.destroy_publisher(publisher)
        if self._commands is not None:
            self.node.destroy_subscription(self._commands)
        if self._arm is not None:
            self._arm.release()

    def _publish_motion(self) -> None:
        stamp = self._stamp
        names, positions, velocities = self.robot.joint_states()
        state = JointState(name=names, position=positions, velocity=velocities)
        state.header.stamp = stamp
        self._joints.publish(state)
        if self.odometry is not None:
            self.odometry.measure(self.world)
            self._publish_odometry(stamp)
        transforms = self.frames.of_base(self.odometry, stamp)
        transforms += self.frames.of_joints(dict(zip(names, positions, strict=True)), stamp)
        self._tf.publish(TFMessage(transforms=transforms))
        if self._truth.is_heard:
            self._publish_truth(stamp)

    def _publish_odometry(self, stamp: Any) -> None:
        odometry, drive = self.odometry, self.drive
        if odometry is None or drive is None or self._odom is None:
            return
        self._odom.publish(odometry_message(odometry, drive, stamp, prefix=self.prefix))

    def _publish_truth(self, stamp: Any) -> None:
        root = self.robot.model.tree.root
        message = Odometry(child_frame_id=self.prefix + root)
        message.header.stamp, message.header.frame_id = stamp, WORLD_FRAME
        _set_pose(message.pose.pose, self.robot.pose)
        linear, angular = self.robot.velocity
        twist = message.twist.twist
        twist.linear.x, twist.linear.y, twist.linear.z = linear.tolist()
        twist.angular.x, twist.angular.y, twist.angular.z = angular.tolist()
        self._truth.publish(message)


def odometry_message(
    odometry: WheelOdometry,
    drive: Drive,
    stamp: Any,
    *,
    pose: Rigid | None = None,
    prefix: str = "",
) -> Any:
    """Return the odometry as a message. `pose` replaces the pose that the wheels tell."""
    message = Odometry(child_frame_id=prefix + drive.base_frame)
    message.header.stamp, message.header.frame_id = stamp, prefix + drive.odometry_frame
    _set_pose(message.pose.pose, pose or odometry.pose)
    twist = message.twist.twist
    twist.linear.x, twist.linear.y, twist.angular.z = odometry.speed
    message.pose.covariance = message.twist.covariance = _COVARIANCE
    return message


class _Timed:
    """Topics of a sensor, with the rate and the time of its measurements."""

    def __init__(self, topic: SensorTopic, rate_hz: float, world: World) -> None:
        self.topic, self.rate_hz, self._world = topic, rate_hz, world
        self.stamp: Any = None

    def run(self) -> None:
        """Measure and publish, if somebody listens."""
        if self.topic.is_heard:
            self.topic.publish(self._world, self.stamp)


def prefixed(description: str, prefix: str) -> str:
    """Return a description whose links have the names of their frames.

    With several robots, each has a text before its frames. Programs that show robots, such as the
    3D view, take the names of links as the names of frames.
    """
    if not prefix:
        return description
    names = r"""(<(?:link\s[^>]*?name|(?:parent|child)\s[^>]*?link)\s*=\s*["'])"""
    return re.sub(names, lambda found: found[1] + prefix, description)


def _set_pose(message: Any, pose: Rigid) -> None:
    place, rotation = message.position, message.orientation
    place.x, place.y, place.z = pose.translation
    rotation.x, rotation.y, rotation.z, rotation.w = pose.rotation


#: Covariance of a wheel odometry: a few centimetres and degrees, and large for what it cannot know.
_COVARIANCE = [0.0] * 36
for _axis, _variance in enumerate((1e-3, 1e-3, 1e6, 1e6, 1e6, 3e-3)):
    _COVARIANCE[7 * _axis] = _variance
