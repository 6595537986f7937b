import math

import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import LaserScan


class Laser(Node):
    def __init__(self):
        super().__init__('laser')
        self.publisher = self.create_publisher(LaserScan, 'scan', 10)
        self.create_subscription(LaserScan, 'scan', self.scanned, 10)
        self.create_timer(0.1, self.scan)

    def scan(self):
        msg = LaserScan()
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id = 'laser'
        msg.angle_min, msg.angle_max = -math.pi, math.pi
        msg.ranges = np.linspace(1, 4, 7, dtype=np.float32).tolist()
        self.publisher.publish(msg)

    def scanned(self, msg):
        ranges = np.array(msg.ranges)
        self.get_logger().info(f'nearest {ranges.min()} at {ranges.argmin()}, mean {ranges.mean()}')


rclpy.init()
rclpy.spin(Laser())
