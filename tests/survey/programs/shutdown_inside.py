"""A node that ends its own spin with SystemExit, and one with rclpy.shutdown()."""

import rclpy
from rclpy.node import Node


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.left = 3
        self.create_timer(0.02, self.tick)

    def tick(self):
        self.left -= 1
        if self.left == 0:
            raise SystemExit


rclpy.init()
node = Counter()
try:
    rclpy.spin(node)
except SystemExit:
    rclpy.logging.get_logger('Quitting').info('Done')
node.destroy_node()
rclpy.shutdown()
