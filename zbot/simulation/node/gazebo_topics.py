"""Topics of a robot that has those of Gazebo: only what its description names."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from zbot.simulation.node.frames import transform
from zbot.simulation.node.robot_topics import RobotTopics, odometry_message
from zbot.simulation.node.schedule import Schedule
from zbot.simulation.robots.equipment import MODEL_FRAME
from zbot.simulation.robots.model import AXIS_FRAME

from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.simulation.robots.equipment import JointCommand, JointStates, LinkPoses
    from zbot.simulation.robots.robot import Robot
    from zbot.simulation.world import World


class GazeboTopics(RobotTopics):
    """Topics of one robot.

    A command lasts until the next command, and no frame is published that no plugin names.

    Args:
        node: The ports of the simulator.
        world: The world of the robot.
        robot: The robot.
    """

    def __init__(self, node: Any, world: World, robot: Robot) -> None:
        super().__init__(node, world, robot, "", has_world=False)
        self.frames.is_silent = True
        equipment = robot.model.equipment
        for states in equipment.joint_states:
            publisher = self._keep(node.create_publisher(JointState, states.topic, 10))
            self.schedules.append(Schedule(states.rate_hz, self._states(publisher, states)))
        for poses in equipment.link_poses:
            self._add_poses(poses)
        self._followed = [
            node.create_subscription(Float64, command.topic, self._commands_of(command), 10)
            for command in equipment.joint_commands
        ]
        for command in equipment.joint_commands:
            robot.joint_motors.command(command.joint, command.kind, command.start)

    def _publishers(self) -> None:
        drive = self.drive
        self._odom = self._wheel_tf = self._odometry_tf = None
        if drive is None:
            return
        make = self.node.create_publisher
        self._odom = self._keep(make(Odometry, self._topic(drive.odometry_topic), 10))
        if drive.odometry_tf:
            self._odometry_tf = self._keep(make(TFMessage, self._topic(drive.odometry_tf), 100))
        if drive.wheel_tf:
            self._wheel_tf = self._keep(make(TFMessage, self._topic(drive.wheel_tf), 100))

    def _topic(self, topic: str) -> str:
        return f"{self.start}{topic.lstrip('/')}"

    def _states(self, publisher: Any, spec: JointStates) -> Callable[[], None]:
        """Return a function that publishes the states of joints."""

        def publish() -> None:
            if not publisher.is_heard:
                return
            message = JointState()
            for name, position, velocity in zip(*self.robot.joint_states(), strict=True):
                if not spec.joints or name in spec.joints:
                    message.name.append(name)
                    message.position.append(position)
                    message.velocity.append(velocity)
                    message.effort.append(self.robot.joint_motors.effort(name))
            message.header.stamp = self._stamp
            publisher.publish(message)

        return publish

    def _add_poses(self, spec: LinkPoses) -> None:
        """Publish the poses of links. Links that no joint moves may have a topic of their own."""
        model = self.robot.model
        links = [link for link in model.tree.links if not link.endswith(AXIS_FRAME)]
        links = links if spec.has_links else []
        fixed = [link for link in links if spec.fixed_topic and model.part_of(link).joint is None]
        moving = [link for link in links if link not in fixed]
        if moving or spec.world:
            self._publish_poses(spec.topic, spec.rate_hz, spec, moving, has_model=bool(spec.world))
        if fixed:
            self._publish_poses(spec.fixed_topic, spec.fixed_rate_hz, spec, fixed)

    def _publish_poses(
        self,
        topic: str,
        rate_hz: float,
        spec: LinkPoses,
        links: list[str],
        *,
        has_model: bool = False,
    ) -> None:
        publisher = self._keep(self.node.create_publisher(TFMessage, topic, 100))

        def publish() -> None:
            if not publisher.is_heard:
                return
            robot, stamp = self.robot, self._stamp
            model = robot.link_pose(MODEL_FRAME)
            back = model.inverse()
            frames = [
                transform(spec.model, f"{spec.model}/{link}", back @ robot.link_pose(link), stamp)
                for link in links
            ]
            if has_model:
                frames.append(transform(spec.world, spec.model, model, stamp))
            publisher.publish(TFMessage(transforms=frames))

        self.schedules.append(Schedule(rate_hz, publish))

    def _commands_of(self, command: JointCommand) -> Callable[[Any], None]:
        def take(message: Any) -> None:
            if math.isfinite(message.data):
                self.robot.joint_motors.command(command.joint, command.kind, message.data)

        return take

    def run(self, stamp: Any, now_ns: int) -> None:
        """Publish what is due. The last command goes on, as in Gazebo."""
        self._last_command_ns = now_ns
        super().run(stamp, now_ns)

    def release(self) -> None:
        """Destroy all topics."""
        super().release()
        for subscription in self._followed:
            self.node.destroy_subscription(subscription)

    def _publish_motion(self) -> None:
        odometry, drive, stamp = self.odometry, self.drive, self._stamp
        if odometry is None or drive is None:
            return
        odometry.measure(self.world)
        pose = self.robot.pose if drive.tells_truth else odometry.pose
        if self._odom is not None and self._odom.is_heard:
            self._odom.publish(odometry_message(odometry, drive, stamp, pose=pose))
        if self._odometry_tf is not None:
            frame = transform(drive.odometry_frame, drive.base_frame, pose, stamp)
            self._odometry_tf.publish(TFMessage(transforms=[frame]))
        if self._wheel_tf is not None:
            self._wheel_tf.publish(TFMessage(transforms=self._wheels()))

    def _wheels(self) -> list[Any]:
        """Return the frames of the wheels in the frame of the base."""
        drive, robot = self.drive, self.robot
        joints = robot.model.tree.joints
        if drive is None or drive.base_frame not in robot.model.tree.links:
            return []
        back = robot.link_pose(drive.base_frame).inverse()
        names = (*drive.left, *drive.right, *drive.steering)
        links = [joints[name].child.removesuffix(AXIS_FRAME) for name in names]
        return [
            transform(drive.base_frame, link, back @ robot.link_pose(link), self._stamp)
            for link in links
        ]
