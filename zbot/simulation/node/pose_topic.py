"""Topics of a robot's true pose, as plugins of Gazebo publish it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.simulation.node.frames import transform
from zbot.simulation.node.sensor_topics import Mount, SensorTopic
from zbot.simulation.rotation import to_matrix

from nav_msgs.msg import Odometry
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from zbot.node.node import Node
    from zbot.simulation.robots.equipment import TruePose
    from zbot.simulation.world import World


class TruePoseTopic(SensorTopic):
    """`nav_msgs/Odometry` with the true pose of a link."""

    def __init__(self, node: Node, sensor: TruePose, mount: Mount) -> None:
        super().__init__(node, sensor, mount)
        self.spec, self.robot, self.number = sensor, mount.robot, mount.number
        self.poses = self.add(Odometry, self.topic)
        self.tf = self.add(TFMessage, sensor.tf_topic) if sensor.tf_topic else None

    def publish(self, world: World, stamp: Any) -> None:
        """Publish the pose and the velocity."""
        spec, pose = self.spec, self.robot.link_pose(self.spec.link)
        linear, angular = self.robot.link_velocity(spec.link)
        back = to_matrix(pose).T
        message = self.stamped(Odometry(child_frame_id=spec.child_frame), stamp)
        noise = world.noise(self.robot, self.number).normal(0.0, spec.noise, 3)
        at, turned = message.pose.pose.position, message.pose.pose.orientation
        at.x, at.y, at.z = (noise + pose.translation).tolist()
        turned.x, turned.y, turned.z, turned.w = pose.rotation
        for vector, values in (
            (message.twist.twist.linear, back @ linear),
            (message.twist.twist.angular, back @ angular),
        ):
            vector.x, vector.y, vector.z = values.tolist()
        self.poses.publish(message)
        if self.tf is not None:
            frame = transform(self.frame, spec.child_frame, pose, stamp)
            self.tf.publish(TFMessage(transforms=[frame]))
