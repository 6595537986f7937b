"""Way out of a maze, with the right hand on the wall: the program hears only the lidar."""

import math
from typing import Any

import zbot
from zbot.qos import qos_profile_sensor_data

from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan

WALL = 0.28  # metres between the lidar and the wall on the right
FREE = 2.0  # outside, nothing ahead is nearer


class Maze(zbot.Node):
    def __init__(self, **options: Any) -> None:
        super().__init__("maze", **options)
        self.is_outside = False
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(LaserScan, "scan", self.look, qos_profile_sensor_data)

    def look(self, scan: LaserScan) -> None:
        ahead, _ = nearest(scan, -15, 15)
        wall, angle = nearest(scan, -135, -40)
        command = Twist()
        if nearest(scan, -90, 90)[0] > FREE:
            self.is_outside = True
            self.get_logger().info("I am outside", once=True)
        elif ahead < 0.3:
            command.angular.z = 1.2
        else:
            # The wall shall be at -90 degrees. Around its end, it is behind, and the robot turns.
            turn = 3.0 * math.radians(angle + 90) + 3.0 * (WALL - wall)
            command.linear.x = 0.3
            command.angular.z = max(-1.4, min(1.4, turn))
        self.publisher.publish(command)


def nearest(scan: LaserScan, first: int, last: int) -> tuple[float, int]:
    """Return the least distance between two angles in degrees, and its angle. Left is positive."""
    found = []
    for angle in range(first, last):
        number = round((math.radians(angle) - scan.angle_min) / scan.angle_increment)
        found.append((scan.ranges[number % len(scan.ranges)], angle))
    return min(found)


if __name__ == "__main__":
    with zbot.init():
        zbot.spin(Maze())
