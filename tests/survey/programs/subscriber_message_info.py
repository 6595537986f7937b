"""A callback with two arguments is given the message's information."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'topic', self.heard, 10)

    def heard(self, msg, info):
        age = self.get_clock().now().nanoseconds - info['source_timestamp']
        self.get_logger().info(f'fresh: {0 <= age < 5e9}')


def main():
    with rclpy.init():
        rclpy.spin(Listener())


main()
