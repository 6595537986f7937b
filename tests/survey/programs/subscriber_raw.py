"""Bytes as they are in ROS 2, and back."""

import rclpy
from rclpy.node import Node
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import String


class Raw(Node):
    def __init__(self):
        super().__init__('raw')
        self.create_subscription(String, 'topic', self.heard, 10, raw=True)

    def heard(self, data: bytes):
        msg = deserialize_message(data, String)
        same = serialize_message(msg) == data
        self.get_logger().info(f'{len(data) > 8} {data[:4].hex()} {same} {msg.data[:5]}')


rclpy.init()
rclpy.spin(Raw())
