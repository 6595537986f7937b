"""Ask an action server for Fibonacci numbers, and log its feedback and result.

Run:  zbot run fibonacci_action_client
Asks: fibonacci (action_tutorials_interfaces/action/Fibonacci)
"""

from typing import Any

import zbot
from zbot.action import ActionClient, ClientGoalHandle

from action_tutorials_interfaces.action import Fibonacci

Handle = ClientGoalHandle[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]


class FibonacciActionClient(zbot.Node):
    """Sends one goal, and logs its feedback and result."""

    def __init__(self) -> None:
        super().__init__("fibonacci_action_client")
        self.action_client: ActionClient[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]
        self.action_client = ActionClient(self, Fibonacci, "fibonacci")

    def send_goal(self, order: int) -> None:
        """Send a goal as soon as the action has a server."""
        goal_msg = Fibonacci.Goal()
        goal_msg.order = order
        self.action_client.wait_for_server()
        future = self.action_client.send_goal_async(goal_msg, self.feedback_callback)
        future.add_done_callback(self.goal_response_callback)

    def goal_response_callback(self, future: zbot.Future[Handle]) -> None:
        """Ask for the result if the server accepts the goal."""
        goal_handle = future.result()
        if goal_handle is None or not goal_handle.accepted:
            self.get_logger().info("Goal rejected :(")
            return
        self.get_logger().info("Goal accepted :)")
        goal_handle.get_result_async().add_done_callback(self.get_result_callback)

    def get_result_callback(self, future: zbot.Future[Any]) -> None:
        """Log the result, and end."""
        response: Any = future.result()
        self.get_logger().info(f"Result: {response.result.sequence}")
        zbot.shutdown()

    def feedback_callback(self, feedback_msg: Any) -> None:
        """Log the numbers computed so far."""
        feedback = feedback_msg.feedback
        self.get_logger().info(f"Received feedback: {feedback.partial_sequence}")


def main() -> None:
    """Send one goal, and run until its result arrives."""
    with zbot.init():
        action_client = FibonacciActionClient()
        action_client.send_goal(10)
        zbot.spin(action_client)


if __name__ == "__main__":
    main()
