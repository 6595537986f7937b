"""Broadcaster of transforms: the frame `moon` moves around the frame `planet`."""

import math

import zbot
from zbot.tf2 import TransformBroadcaster

from geometry_msgs.msg import TransformStamped


class Broadcaster(zbot.Node):
    def __init__(self) -> None:
        super().__init__("tf_broadcaster")
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.05, self.broadcast)

    def broadcast(self) -> None:
        now = self.get_clock().now()
        angle = now.nanoseconds / 1e9 % (2 * math.pi)  # radians
        transform = TransformStamped()
        transform.header.stamp = now.to_msg()
        transform.header.frame_id = "planet"
        transform.child_frame_id = "moon"
        transform.transform.translation.x = 2 * math.cos(angle)  # metres
        transform.transform.translation.y = 2 * math.sin(angle)
        transform.transform.rotation.z = math.sin(angle / 2)
        transform.transform.rotation.w = math.cos(angle / 2)
        self.broadcaster.sendTransform(transform)


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Broadcaster())
