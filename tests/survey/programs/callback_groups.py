"""Two slow callbacks run at the same time in a reentrant group."""

import threading

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class Together(Node):
    def __init__(self):
        super().__init__('together')
        self.meeting = threading.Barrier(2, timeout=5)
        group = ReentrantCallbackGroup()
        self.a = self.create_timer(0.1, lambda: self.meet('a'), callback_group=group)
        self.b = self.create_timer(0.1, lambda: self.meet('b'), callback_group=group)

    def meet(self, name):
        self.meeting.wait()
        self.get_logger().info(f'{name} was not alone', once=True)


rclpy.init()
executor = MultiThreadedExecutor(4)
executor.add_node(Together())
executor.spin()
