"""Keeper who follows a goal by callbacks, and sends others that end in every other way."""

from typing import Any

import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from rclpy.task import Future

from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci

NAMES = {
    GoalStatus.STATUS_SUCCEEDED: "succeeded",
    GoalStatus.STATUS_CANCELED: "canceled",
    GoalStatus.STATUS_ABORTED: "aborted",
}


class Keeper(Node):
    def __init__(self) -> None:
        super().__init__("keeper")
        self.breed = ActionClient(self, Fibonacci, "breed")
        self.counts: list[int] = []
        self.over = Future()

    def begin(self, seasons: int) -> None:
        self.breed.wait_for_server()
        sending = self.breed.send_goal_async(Fibonacci.Goal(order=seasons), self.on_feedback)
        sending.add_done_callback(self.on_answer)

    def on_feedback(self, message: Any) -> None:
        self.counts.append(message.feedback.sequence[-1])

    def on_answer(self, future: Future) -> None:
        handle = future.result()
        self.get_logger().info(f"accepted: {handle.accepted}")
        handle.get_result_async().add_done_callback(self.on_result)

    def on_result(self, future: Future) -> None:
        self.over.set_result(list(future.result().result.sequence))


def waited(node: Node, future: Future) -> Any:
    rclpy.spin_until_future_complete(node, future, timeout_sec=60)
    return future.result()


rclpy.init()
keeper = Keeper()
keeper.begin(5)
print("result", waited(keeper, keeper.over), "feedback", keeper.counts)

refused = waited(keeper, keeper.breed.send_goal_async(Fibonacci.Goal(order=0)))
print("refused", not refused.accepted)

fox = waited(keeper, keeper.breed.send_goal_async(Fibonacci.Goal(order=7)))
print("seven seasons", NAMES[waited(keeper, fox.get_result_async()).status])

endless = waited(keeper, keeper.breed.send_goal_async(Fibonacci.Goal(order=100000)))
answer = waited(keeper, endless.cancel_goal_async())
print(
    "canceling",
    len(answer.goals_canceling),
    NAMES[waited(keeper, endless.get_result_async()).status],
)
rclpy.shutdown()
