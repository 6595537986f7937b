"""Crane whose hook is looked up through a fixed mast and a boom that turns."""

import math

import rclpy
import tf2_geometry_msgs  # noqa: F401 - lets `transform` take points
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import (
    Buffer,
    LookupException,
    StaticTransformBroadcaster,
    TransformBroadcaster,
    TransformListener,
)

from geometry_msgs.msg import PointStamped, Quaternion, TransformStamped


def transform(node: Node, parent: str, child: str, x: float, z: float, turn: float):  # noqa: ANN201
    made = TransformStamped(child_frame_id=child)
    made.header.stamp = node.get_clock().now().to_msg()
    made.header.frame_id = parent
    made.transform.translation.x, made.transform.translation.z = x, z
    made.transform.rotation = Quaternion(z=math.sin(turn / 2), w=math.cos(turn / 2))
    return made


class Drive(Node):
    def __init__(self) -> None:
        super().__init__("drive")
        StaticTransformBroadcaster(self).sendTransform(
            transform(self, "yard", "mast", 10.0, 30.0, 0.0)
        )
        self.moving = TransformBroadcaster(self)
        self.create_timer(0.02, self.turn)

    def turn(self) -> None:
        self.moving.sendTransform(transform(self, "mast", "boom", 0.0, 0.0, math.pi / 2))


class Hook(Node):
    def __init__(self, ended: rclpy.Future) -> None:
        super().__init__("hook")
        self.buffer, self.ended = Buffer(), ended
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(0.02, self.look)

    def look(self) -> None:
        if not self.buffer.can_transform("yard", "boom", Time()):
            return
        point = PointStamped()
        point.header.frame_id = "boom"
        point.point.x = 5.0
        found = self.buffer.transform(point, "yard", Duration(seconds=1)).point
        try:
            self.buffer.lookup_transform("yard", "ship", Time())
        except LookupException:
            self.ended.set_result(f"hook at {found.x:.1f} {found.y:.1f} {found.z:.1f}, no ship")


rclpy.init()
ended = rclpy.Future()
executor = MultiThreadedExecutor()
for node in (Drive(), Hook(ended)):
    executor.add_node(node)
executor.spin_until_future_complete(ended, timeout_sec=60)
print(ended.result())
executor.shutdown()
rclpy.shutdown()
