import rclpy
from rclpy.node import Node


class Countdown(Node):
    def __init__(self):
        super().__init__('countdown')
        self.left = 3
        self._timer = self.create_timer(0.05, self.count)

    def count(self):
        self.left -= 1
        self.get_logger().info(f'{self.left} left')
        if self.left == 0:
            self._timer.cancel()
            raise SystemExit


rclpy.init()
node = Countdown()
try:
    rclpy.spin(node)
except SystemExit:
    rclpy.logging.get_logger('Quitting').info('Done')
node.destroy_node()
rclpy.shutdown()
