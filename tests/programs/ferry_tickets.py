"""Passengers who wait for the ferry in the four ways of a single thread."""

from functools import partial

import rclpy
from rclpy.node import Node
from rclpy.task import Future

from std_srvs.srv import Trigger


class Passenger(Node):
    def __init__(self) -> None:
        super().__init__("passenger")
        self.ferry = self.create_client(Trigger, "/ferry/depart")
        self.ashore = Future()
        while not self.ferry.wait_for_service(timeout_sec=0.5):
            self.get_logger().info("no ferry yet")

    def until_complete(self) -> str:
        future = self.ferry.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=60)
        return str(future.result().message)

    def polled(self) -> str:
        future = self.ferry.call_async(Trigger.Request())
        while rclpy.ok() and not future.done():
            rclpy.spin_once(self, timeout_sec=0.1)
        return str(future.result().message)

    def with_a_callback(self) -> str:
        future = self.ferry.call_async(Trigger.Request())
        future.add_done_callback(partial(self.land, bags=2))
        rclpy.spin_until_future_complete(self, self.ashore, timeout_sec=60)
        return str(self.ashore.result())

    def land(self, future: Future, bags: int) -> None:
        self.ashore.set_result(f"{future.result().message} with {bags} bags")

    def awaited(self) -> str:
        ended = Future()

        async def travel() -> None:
            timer.cancel()
            first = await self.ferry.call_async(Trigger.Request())
            second = await self.ferry.call_async(Trigger.Request())
            ended.set_result(f"{first.message} and {second.message}")

        timer = self.create_timer(0.01, travel)
        rclpy.spin_until_future_complete(self, ended, timeout_sec=60)
        return str(ended.result())


rclpy.init()
passenger = Passenger()
print(passenger.until_complete(), "|", passenger.polled())
print(passenger.with_a_callback(), "|", passenger.awaited())
rclpy.shutdown()
