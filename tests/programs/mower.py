"""Mower that integrates its commands into odometry and a path, here around a quarter circle."""

import math

import rclpy
from rclpy.node import Node

from geometry_msgs.msg import PoseStamped, Quaternion, Twist
from nav_msgs.msg import Odometry, Path

STEPS, STEP_S = 20, 0.1


class Mower(Node):
    def __init__(self) -> None:
        super().__init__("mower")
        self.x = self.y = self.heading = 0.0
        self.path = Path()
        self.path.header.frame_id = "lawn"
        self.odometry = self.create_publisher(Odometry, "odom", 50)
        self.create_subscription(Twist, "cmd_vel", self.drive, STEPS)
        self.create_subscription(Odometry, "odom", self.record, 50)

    def drive(self, command: Twist) -> None:
        middle = self.heading + command.angular.z * STEP_S / 2
        self.x += command.linear.x * STEP_S * math.cos(middle)
        self.y += command.linear.x * STEP_S * math.sin(middle)
        self.heading += command.angular.z * STEP_S
        at = Odometry(child_frame_id="mower")
        at.header.stamp = self.get_clock().now().to_msg()
        at.header.frame_id = "lawn"
        at.pose.pose.position.x, at.pose.pose.position.y = self.x, self.y
        at.pose.pose.orientation = Quaternion(
            z=math.sin(self.heading / 2), w=math.cos(self.heading / 2)
        )
        at.pose.covariance[35] = 0.01
        at.twist.twist = command
        self.odometry.publish(at)

    def record(self, at: Odometry) -> None:
        self.path.poses.append(PoseStamped(header=at.header, pose=at.pose.pose))


rclpy.init()
mower = Mower()
commands = mower.create_publisher(Twist, "cmd_vel", STEPS)
turn = Twist()
turn.linear.x, turn.angular.z = math.pi / 2, math.pi / 2 / (STEPS * STEP_S)
for _ in range(STEPS):
    commands.publish(turn)
for _ in range(1000):
    if len(mower.path.poses) == STEPS:
        break
    rclpy.spin_once(mower, timeout_sec=0.1)
last = mower.path.poses[-1]
turned = 2 * math.degrees(math.atan2(last.pose.orientation.z, last.pose.orientation.w))
print(f"{len(mower.path.poses)} poses on the {last.header.frame_id}")
print(f"at {last.pose.position.x:.2f} {last.pose.position.y:.2f}, turned by {turned:.1f}")
rclpy.shutdown()
