import rclpy
from rclpy.node import Node
from rclpy.task import Future


class Sleeper(Node):
    def __init__(self):
        super().__init__('sleeper')
        self.timer = self.create_timer(0.05, self.work)
        self.turns = 0

    async def sleep(self, seconds):
        future = Future()
        timer = self.create_timer(seconds, lambda: future.set_result(True),
                                  callback_group=rclpy.callback_groups.ReentrantCallbackGroup())
        await future
        timer.cancel()

    async def work(self):
        self.timer.cancel()
        await self.sleep(0.1)
        self.get_logger().info('slept without blocking')


rclpy.init()
rclpy.spin(Sleeper())
