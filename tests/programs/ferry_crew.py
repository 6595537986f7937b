"""Crew that calls the ferry and blocks: from the main thread, and within a callback."""

import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from std_srvs.srv import SetBool


class Crew(Node):
    def __init__(self) -> None:
        super().__init__("crew")
        self.answer = ""
        self.answered = threading.Event()
        self.ramp = self.create_client(
            SetBool, "/ferry/ramp", callback_group=MutuallyExclusiveCallbackGroup()
        )
        self.timer = self.create_timer(0.01, self.work)

    def work(self) -> None:
        self.timer.cancel()
        self.answer = self.ramp.call(SetBool.Request(data=True)).message
        self.answered.set()


rclpy.init()
crew = Crew()
print("found", crew.ramp.wait_for_service(timeout_sec=60))
executor = MultiThreadedExecutor(num_threads=2)
executor.add_node(crew)
thread = threading.Thread(target=executor.spin)
thread.start()
print("in a callback", crew.answered.wait(60), crew.answer)
down = crew.ramp.call(SetBool.Request(data=False))
again = crew.ramp.call(SetBool.Request(data=False))
print("in the main thread", down.success, again.success)
executor.shutdown()
thread.join()
rclpy.shutdown()
