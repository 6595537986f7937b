"""Bakery that works by the clock, and by one that a simulation moves."""

import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.time import Time

from rosgraph_msgs.msg import Clock as ClockMessage


class Bakery(Node):
    def __init__(self) -> None:
        super().__init__("bakery", parameter_overrides=[Parameter("use_sim_time", value=True)])
        self.hours = 0
        self.clock = self.create_publisher(ClockMessage, "/clock", 10)
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self.create_timer(0.02, self.move, clock=steady)
        self.create_timer(7200.0, self.bake)

    def move(self) -> None:
        self.hours += 1
        self.clock.publish(ClockMessage(clock=Time(seconds=3600 * self.hours).to_msg()))

    def bake(self) -> None:
        now = self.get_clock().now()
        if now >= Time(seconds=5 * 3600, clock_type=ClockType.ROS_TIME):
            print("bread within the sixth hours:", now.seconds_nanoseconds()[0] <= 8 * 3600)
            rclpy.shutdown()


rclpy.init()
steady = Clock(clock_type=ClockType.STEADY_TIME)
before = steady.now()
print(
    "rested",
    steady.sleep_for(Duration(seconds=0.03)),
    steady.now() - before >= Duration(nanoseconds=30_000_000),
)
dough = Time(seconds=100, nanoseconds=5) + Duration(seconds=1.5)
print(
    dough.nanoseconds,
    Time.from_msg(dough.to_msg(), ClockType.SYSTEM_TIME)
    == Time(seconds=101, nanoseconds=500_000_005),
)
try:
    print(Clock().now() < before)
except TypeError:
    print("clocks differ")
try:
    rclpy.spin(Bakery())
except ExternalShutdownException:
    print("ended from outside")
print("running", rclpy.ok())
