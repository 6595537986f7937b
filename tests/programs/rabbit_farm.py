"""Farm that breeds rabbits as an action, one goal beside the other."""

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from example_interfaces.action import Fibonacci


class Farm(Node):
    def __init__(self) -> None:
        super().__init__("farm")
        self.seasons = self.create_rate(100)
        self.server = ActionServer(
            self,
            Fibonacci,
            "breed",
            execute_callback=self.breed,
            goal_callback=self.consider,
            cancel_callback=self.stop,
            callback_group=ReentrantCallbackGroup(),
        )

    def consider(self, goal: Fibonacci.Goal) -> GoalResponse:
        return GoalResponse.REJECT if goal.order < 1 else GoalResponse.ACCEPT

    def stop(self, handle: ServerGoalHandle) -> CancelResponse:
        self.get_logger().info(f"no more than {handle.request.order} seasons were wanted")
        return CancelResponse.ACCEPT

    def breed(self, handle: ServerGoalHandle) -> Fibonacci.Result:
        pairs = [1, 1]
        while len(pairs) < handle.request.order:
            if handle.is_cancel_requested:
                handle.canceled()
                return Fibonacci.Result(sequence=pairs)
            pairs.append((pairs[-2] + pairs[-1]) % 1000)  # the farm sells them by the thousand
            handle.publish_feedback(Fibonacci.Feedback(sequence=pairs))
            self.seasons.sleep()
        if pairs[-1] == 13:
            self.get_logger().error("a fox came")
            handle.abort()
        else:
            handle.succeed()
        return Fibonacci.Result(sequence=pairs)


def main() -> None:
    rclpy.init()
    farm = Farm()
    try:
        rclpy.spin(farm, executor=MultiThreadedExecutor())
    except KeyboardInterrupt:
        farm.server.destroy()
    rclpy.try_shutdown()


main()
