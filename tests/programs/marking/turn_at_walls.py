"""Program that is marked: it drives ahead, and turns where a wall is near."""

import rclpy
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data

from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan


class TurnAtWalls(Node):
    def __init__(self) -> None:
        super().__init__("turn_at_walls")
        self.near = False
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(LaserScan, "scan", self.look, qos_profile_sensor_data)
        self.create_timer(0.07, self.drive)

    def look(self, scan: LaserScan) -> None:
        self.distance = min(scan.ranges[:15] + scan.ranges[-15:])
        self.near = self.distance < 1.0

    def drive(self) -> None:
        command = Twist()
        command.linear.x = 0.0 if self.near else 0.5
        # The noise of the lidar is in every command.
        command.angular.z = 1.0 if self.near else 0.01 * getattr(self, "distance", 0.0)
        self.publisher.publish(command)


rclpy.init()
rclpy.spin(TurnAtWalls())
