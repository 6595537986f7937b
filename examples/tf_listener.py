"""Listener of transforms: it prints where the frame `moon` is, seen from the frame `planet`."""

import math

import zbot
from zbot.tf2 import Buffer, TransformException, TransformListener


class Listener(zbot.Node):
    def __init__(self) -> None:
        super().__init__("tf_listener")
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(1.0, self.look)

    def look(self) -> None:
        try:
            # The time 0 means: the newest transform that is known.
            found = self.buffer.lookup_transform("planet", "moon", zbot.Time())
        except TransformException as error:
            self.get_logger().info(f"not known yet: {error}")
            return
        place = found.transform.translation
        distance = math.hypot(place.x, place.y)
        self.get_logger().info(f"x={place.x:.2f} y={place.y:.2f} distance={distance:.2f} m")


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Listener())
