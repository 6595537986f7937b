"""Composition: talker and listener in one process."""

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.tmr = self.create_timer(0.1, self.callback)
        self.i = 0

    def callback(self):
        self.i += 1
        self.pub.publish(String(data=f'Hello World: {self.i}'))


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.sub = self.create_subscription(String, 'chatter', self.callback, 10)

    def callback(self, msg):
        self.get_logger().info('I heard: [%s]' % msg.data)


def main():
    rclpy.init()
    try:
        executor = SingleThreadedExecutor()
        nodes = [Talker(), Listener()]
        for node in nodes:
            executor.add_node(node)
        try:
            executor.spin()
        finally:
            executor.shutdown()
            for node in nodes:
                node.destroy_node()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


main()
