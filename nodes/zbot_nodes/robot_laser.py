"""Measure the distances to the walls in all directions, as a simulated laser scanner.

Run:       zbot run robot_laser      (together with zbot run robot_base)
Publishes: scan (sensor_msgs/LaserScan), 360 distances ten times a second
Try:       zbot topic echo /scan --field ranges[0]
"""

import math
import random

import zbot
from zbot.qos import qos_profile_sensor_data
from zbot_nodes.robot.pose import TRUTH, Pose, pose_of
from zbot_nodes.robot.world import distance

from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

PERIOD_S = 0.1
RAYS = 360
NOISE_M = 0.01


class Laser(zbot.Node):
    """Scans in a full circle ten times a second. The first ray points ahead."""

    def __init__(self) -> None:
        super().__init__("laser_scanner")
        self.pose = Pose()
        self.publisher = self.create_publisher(LaserScan, "scan", qos_profile_sensor_data)
        self.subscription = self.create_subscription(Odometry, TRUTH, self.locate, 10)
        self.timer = self.create_timer(PERIOD_S, self.scan)
        self.get_logger().info("Laser ready: distances on /scan")

    def locate(self, msg: Odometry) -> None:
        """Store the pose of the robot."""
        self.pose = pose_of(msg)

    def scan(self) -> None:
        """Publish one scan."""
        msg = LaserScan(angle_max=2 * math.pi, angle_increment=2 * math.pi / RAYS)
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id = "laser"
        msg.time_increment, msg.scan_time = PERIOD_S / RAYS, PERIOD_S
        msg.range_min, msg.range_max = 0.12, 12.0
        msg.ranges = [self.measure(ray * msg.angle_increment) for ray in range(RAYS)]
        self.publisher.publish(msg)

    def measure(self, angle: float) -> float:
        """Return the distance in one direction, with the scanner's small error."""
        x, y, yaw = self.pose
        return distance(x, y, yaw + angle) + random.gauss(0.0, NOISE_M)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(Laser())


if __name__ == "__main__":
    main()
