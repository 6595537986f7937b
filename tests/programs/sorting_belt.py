"""Sorting belt: a feeder and a sorter in one executor; the sorter ends the program itself."""

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from std_msgs.msg import Int32


class Feeder(Node):
    def __init__(self) -> None:
        super().__init__("feeder")
        self.fed = 0
        self.pauses = 0
        self.parcels = self.create_publisher(Int32, "parcels", 10)
        self.feeding = self.create_timer(0.01, self.feed)
        self.resting = self.create_timer(0.05, self.rest, autostart=False)

    def feed(self) -> None:
        self.fed += 1
        self.parcels.publish(Int32(data=self.fed))
        if self.fed % 3 == 0:
            self.feeding.cancel()
            self.resting.reset()

    def rest(self) -> None:
        self.pauses += 1
        self.resting.cancel()
        self.get_logger().info(f"fed {self.fed}, stopped {self.feeding.is_canceled()}")
        self.feeding.reset()


class Sorter(Node):
    def __init__(self) -> None:
        super().__init__("sorter")
        self.bins: dict[str, list[int]] = {"even": [], "odd": []}
        self.create_subscription(Int32, "parcels", self.sort, 10)

    def sort(self, parcel: Int32) -> None:
        self.bins["odd" if parcel.data % 2 else "even"].append(parcel.data)
        if parcel.data == 7:
            self.get_logger().info(f"even {self.bins['even']} odd {self.bins['odd']}")
            raise SystemExit


rclpy.init()
feeder, sorter = Feeder(), Sorter()
executor = SingleThreadedExecutor()
executor.add_node(feeder)
executor.add_node(sorter)
try:
    executor.spin()
except SystemExit:
    feeder.destroy_timer(feeder.feeding)
    print("belt off after", feeder.pauses, "pauses,", len(list(feeder.timers)), "timer left")
executor.shutdown()
rclpy.shutdown()
