"""Two subscriptions with a slow callback: depth 1 drops messages, keep-all gets all of them."""

import time

import zbot
from zbot import HistoryPolicy, QoSProfile

from std_msgs.msg import Int64

LATEST = QoSProfile(depth=1)
ALL = QoSProfile(history=HistoryPolicy.KEEP_ALL)


class SlowReader(zbot.Node):
    def __init__(self) -> None:
        super().__init__("slow_reader")
        self.latest: list[int] = []
        self.all: list[int] = []
        self.publisher = self.create_publisher(Int64, "count", ALL)
        self.create_subscription(Int64, "count", self.on_latest, LATEST)
        self.create_subscription(Int64, "count", lambda number: self.all.append(number.data), ALL)
        self.create_timer(1.0, self.publish_ten)

    def publish_ten(self) -> None:
        self.get_logger().info(f"depth 1 saw {self.latest}, keep-all saw {self.all}")
        self.latest, self.all = [], []
        for number in range(10):
            self.publisher.publish(Int64(data=number))

    def on_latest(self, number: Int64) -> None:
        self.latest.append(number.data)
        time.sleep(0.05)


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(SlowReader())
