"""Compute Fibonacci numbers slowly, as an action.

Run:     zbot run fibonacci_action_server
Serves:  fibonacci (action_tutorials_interfaces/action/Fibonacci), one number a second
Send it: zbot action send_goal --feedback /fibonacci "order: 5"     (Ctrl-C cancels the goal)
"""

import time

import zbot
from zbot.action import ActionServer, CancelResponse, ServerGoalHandle

from action_tutorials_interfaces.action import Fibonacci

Goal = ServerGoalHandle[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]


class FibonacciActionServer(zbot.Node):
    """Sends the sequence as feedback after each new number, and at the end as the result."""

    def __init__(self) -> None:
        super().__init__("fibonacci_action_server")
        self.action_server: ActionServer[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback]
        self.action_server = ActionServer(
            self,
            Fibonacci,
            "fibonacci",
            self.execute_callback,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )

    def execute_callback(self, goal_handle: Goal) -> Fibonacci.Result:
        """Execute one goal."""
        self.get_logger().info("Executing goal...")
        feedback_msg = Fibonacci.Feedback()
        feedback_msg.partial_sequence = [0, 1]
        for i in range(1, goal_handle.request.order):
            if goal_handle.is_cancel_requested:
                self.get_logger().info("Goal canceled")
                goal_handle.canceled()
                return Fibonacci.Result(sequence=feedback_msg.partial_sequence)
            feedback_msg.partial_sequence.append(
                feedback_msg.partial_sequence[i] + feedback_msg.partial_sequence[i - 1]
            )
            self.get_logger().info(f"Feedback: {feedback_msg.partial_sequence}")
            goal_handle.publish_feedback(feedback_msg)
            time.sleep(1)
        goal_handle.succeed()
        return Fibonacci.Result(sequence=feedback_msg.partial_sequence)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        # One thread can receive a cancel request while another thread sleeps.
        zbot.spin(FibonacciActionServer(), executor=zbot.MultiThreadedExecutor())


if __name__ == "__main__":
    main()
