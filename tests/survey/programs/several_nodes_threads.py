import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int32


class Estop(Node):
    def __init__(self):
        super().__init__('worker')
        self.slow = MutuallyExclusiveCallbackGroup()
        self.fast = ReentrantCallbackGroup()
        self.lock = threading.Lock()
        self.count = 0
        self.release = threading.Event()
        self.create_timer(0.05, self.block, callback_group=self.slow)
        self.create_timer(0.05, self.tick, callback_group=self.fast)
        self.pub = self.create_publisher(Int32, 'count', 10)

    def block(self):
        self.release.wait(1.0)

    def tick(self):
        with self.lock:
            self.count += 1
        self.pub.publish(Int32(data=self.count))
        self.get_logger().info(f'still alive {self.count}')


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(Estop())
    executor.add_node(Node('beside'))
    try:
        executor.spin()
    finally:
        executor.shutdown()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
