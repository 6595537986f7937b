"""Server of an action: a goal takes time, sends feedback, and has a result at the end."""

import time
from typing import Any

import zbot
from zbot.action import ActionServer, CancelResponse

from example_interfaces.action import Fibonacci


class Server(zbot.Node):
    def __init__(self) -> None:
        super().__init__("action_server")
        self.server: Any = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            self.execute,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )
        self.get_logger().info("the action is ready")

    def execute(self, goal: Any) -> Fibonacci.Result:
        numbers = [0, 1]
        while len(numbers) <= goal.request.order:
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=numbers)
            numbers.append(numbers[-1] + numbers[-2])
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
            time.sleep(0.5)
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)


if __name__ == "__main__":
    with zbot.init():
        # One thread can receive a cancel request while another thread executes a goal.
        zbot.spin(Server(), executor=zbot.MultiThreadedExecutor())
