"""Program that is marked: it drives ahead. Words on its command line let it go wrong."""

import os

import rclpy
from rclpy.node import Node

from geometry_msgs.msg import Twist

FAULT = os.environ.get("FAULT", "")


class Ahead(Node):
    def __init__(self) -> None:
        super().__init__("ahead")
        topic = "cmd_val" if FAULT == "typo" else "cmd_vel"
        self.publisher = self.create_publisher(Twist, topic, 10)
        self.create_timer(0.1, self.drive)

    def drive(self) -> None:
        command = Twist()
        command.linear.x = 0.4
        if FAULT == "silence":
            return
        if FAULT == "flood":
            print("x" * 1_000_000)
        if FAULT == "crash":
            command.linear.y = no_such_name  # noqa: F821 - this is the fault
        while FAULT == "hang":
            pass
        self.publisher.publish(command)


if FAULT != "end":
    rclpy.init()
    rclpy.spin(Ahead())
