"""Started with `--ros-args`: other names, and a parameter."""

import sys

import rclpy
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String


class Remapped(Node):
    def __init__(self):
        super().__init__('original')
        self.declare_parameter('greeting', 'none')
        self.pub = self.create_publisher(String, 'topic', 10)
        words = remove_ros_args(args=sys.argv)[1:]
        self.get_logger().info(
            f"{self.get_fully_qualified_name()} {self.pub.topic_name} "
            f"{self.get_parameter('greeting').value} {words}")


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Remapped())


main()
