import numpy as np
import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import (DurabilityPolicy, HistoryPolicy, QoSProfile, QoSReliabilityPolicy,
                       ReliabilityPolicy, qos_profile_sensor_data)
from sensor_msgs.msg import LaserScan


class Scanner(Node):
    def __init__(self):
        super().__init__('scanner')
        qos = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=5,
                         reliability=ReliabilityPolicy.BEST_EFFORT,
                         durability=DurabilityPolicy.VOLATILE, deadline=Duration(seconds=1))
        self.pub = self.create_publisher(LaserScan, '/scan', qos)
        self.sub = self.create_subscription(
            LaserScan, '/scan', self.on_scan, qos_profile_sensor_data,
            event_callbacks=SubscriptionEventCallbacks(matched=lambda e: print('matched', e.current_count)))
        self.create_timer(0.05, self.tick)

    def tick(self):
        msg = LaserScan()
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.ranges = np.linspace(1, 2, 5).astype(np.float32).tolist()
        msg.angle_min = -1.57
        self.pub.publish(msg)

    def on_scan(self, msg):
        closest = min(msg.ranges)
        self.get_logger().info(f'closest {closest:.2f} of {len(msg.ranges)}', throttle_duration_sec=0.2)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Scanner())


if __name__ == '__main__':
    main()
