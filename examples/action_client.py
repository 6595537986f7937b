"""Client of an action: it sends a goal, prints the feedback and the result, and ends."""

from typing import Any

import zbot
from zbot.action import ActionClient

from example_interfaces.action import Fibonacci


def print_feedback(message: Any) -> None:
    print("so far:", list(message.feedback.sequence))


if __name__ == "__main__":
    with zbot.init():
        node = zbot.Node("action_client")
        client: Any = ActionClient(node, Fibonacci, "fibonacci")
        if not client.wait_for_server(timeout_sec=10):
            raise SystemExit("no server: start action_server.py first")
        sent = client.send_goal_async(Fibonacci.Goal(order=5), feedback_callback=print_feedback)
        zbot.spin_until_future_complete(node, sent)
        goal = sent.result()
        if not goal.accepted:
            raise SystemExit("the server rejected the goal")
        finished = goal.get_result_async()
        zbot.spin_until_future_complete(node, finished)
        print("result:", list(finished.result().result.sequence))
