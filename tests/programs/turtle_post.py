"""Turtle that brings a letter to a house that appears where a service puts it."""

import math

import rclpy
from rclpy.node import Node

from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from turtlesim.srv import SetPen, Spawn


class Postman(Node):
    def __init__(self) -> None:
        super().__init__("postman")
        self.house: Pose | None = None
        self.delivered = rclpy.Future()
        self.wheels = self.create_publisher(Twist, "turtle1/cmd_vel", 1)
        self.pen = self.create_client(SetPen, "turtle1/set_pen")
        self.builder = self.create_client(Spawn, "spawn")
        self.create_subscription(Pose, "house/pose", self.on_house, 1)
        self.create_subscription(Pose, "turtle1/pose", self.on_pose, 1)

    def build(self) -> str:
        self.builder.wait_for_service(60)
        building = self.builder.call_async(Spawn.Request(x=7.5, y=6.5, name="house"))
        rclpy.spin_until_future_complete(self, building, timeout_sec=60)
        self.pen.call_async(SetPen.Request(r=200, width=3))
        return str(building.result().name)

    def on_house(self, house: Pose) -> None:
        self.house = house

    def on_pose(self, here: Pose) -> None:
        if self.house is None or self.delivered.done():
            return
        way = math.dist((here.x, here.y), (self.house.x, self.house.y))
        bearing = math.atan2(self.house.y - here.y, self.house.x - here.x)
        step = Twist()
        if way < 0.2:
            self.delivered.set_result(way)
        else:
            step.linear.x = min(2 * way, 6.0)
            step.angular.z = 6 * math.remainder(bearing - here.theta, math.tau)
        self.wheels.publish(step)


rclpy.init()
postman = Postman()
print("built the", postman.build())
rclpy.spin_until_future_complete(postman, postman.delivered, timeout_sec=60)
print("letter delivered", postman.delivered.result() < 0.2)
rclpy.shutdown()
