"""Measure rotation and acceleration of the robot, as a simulated inertial sensor.

Run:       zbot run robot_imu        (together with zbot run robot_base)
Publishes: imu (sensor_msgs/Imu), a hundred times a second
Try:       zbot topic echo /imu --field angular_velocity.z
"""

import random

import zbot
from zbot.qos import qos_profile_sensor_data
from zbot_nodes.robot.pose import TRUTH

from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu

PERIOD_S = 0.01
GRAVITY_M_S2 = 9.81
TURN_NOISE_RAD_S = 0.002
PUSH_NOISE_M_S2 = 0.02


class InertialSensor(zbot.Node):
    """Publishes the exact orientation, and the rotation and acceleration with a small error."""

    def __init__(self) -> None:
        super().__init__("imu")
        self.motion = Odometry()
        self.last_speed = 0.0
        self.publisher = self.create_publisher(Imu, "imu", qos_profile_sensor_data)
        self.subscription = self.create_subscription(Odometry, TRUTH, self.locate, 10)
        self.timer = self.create_timer(PERIOD_S, self.publish_reading)
        self.get_logger().info("Inertial sensor ready: rotation and acceleration on /imu")

    def locate(self, msg: Odometry) -> None:
        """Store the pose and the velocity of the robot."""
        self.motion = msg

    def publish_reading(self) -> None:
        """Publish one reading."""
        moves = self.motion.twist.twist
        msg = Imu(orientation=self.motion.pose.pose.orientation)
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.header.frame_id = "imu_link"
        msg.angular_velocity.z = moves.angular.z + random.gauss(0.0, TURN_NOISE_RAD_S)
        gain = (moves.linear.x - self.last_speed) / PERIOD_S
        self.last_speed = moves.linear.x
        msg.linear_acceleration.x = gain + random.gauss(0.0, PUSH_NOISE_M_S2)
        # In a curve, the acceleration points to the inside of the curve.
        msg.linear_acceleration.y = moves.linear.x * moves.angular.z
        msg.linear_acceleration.z = GRAVITY_M_S2 + random.gauss(0.0, PUSH_NOISE_M_S2)
        self.publisher.publish(msg)


def main() -> None:
    """Run until Ctrl-C."""
    with zbot.init():
        zbot.spin(InertialSensor())


if __name__ == "__main__":
    main()
