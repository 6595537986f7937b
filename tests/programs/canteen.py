"""Canteen with groups: two cooks at the same time, one till, and a guest in another thread."""

import contextlib
import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node

from std_msgs.msg import String


class Canteen(Node):
    def __init__(self) -> None:
        super().__init__("canteen")
        self.both, self.till = threading.Barrier(2), threading.Lock()
        self.paid = self.clashes = 0
        self.cooked = self.create_publisher(String, "cooked", 10)
        stove, coins = ReentrantCallbackGroup(), MutuallyExclusiveCallbackGroup()
        for _ in range(2):
            self.create_timer(0.01, self.cook, callback_group=stove)
            self.create_timer(0.002, self.pay, callback_group=coins)

    def cook(self) -> None:
        with contextlib.suppress(threading.BrokenBarrierError):  # the canteen closes
            self.both.wait(60)  # passes only when both are here
            self.cooked.publish(String(data="soup"))

    def pay(self) -> None:
        if not self.till.acquire(blocking=False):
            self.clashes += 1
            return
        served.wait(0.001)  # counting the coins takes a moment
        self.till.release()
        self.paid += 1


rclpy.init()
canteen, guest = Canteen(), rclpy.create_node("guest")
served = threading.Event()
plates: list[tuple[str, str]] = []


def eat(soup: String) -> None:
    plates.append((soup.data, threading.current_thread().name))
    if len(plates) >= 2 and canteen.paid > 10:
        served.set()


guest.create_subscription(String, "cooked", eat, 10)
kitchen, table = MultiThreadedExecutor(num_threads=4), SingleThreadedExecutor()
kitchen.add_node(canteen)
table.add_node(guest)
threads = [
    threading.Thread(target=kitchen.spin, name="kitchen"),
    threading.Thread(target=table.spin, name="table"),
]
for thread in threads:
    thread.start()
print("served", served.wait(60), set(plates))
canteen.both.abort()
table.shutdown()
kitchen.shutdown()
for thread in threads:
    thread.join()
print("paid", canteen.paid > 10, "clashes", canteen.clashes)
rclpy.shutdown()
