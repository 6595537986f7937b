import math

import rclpy
from geometry_msgs.msg import Pose, PoseStamped, Quaternion, Twist, Vector3
from nav_msgs.msg import Odometry, Path
from rclpy.node import Node


class DeadReckoning(Node):
    def __init__(self):
        super().__init__('dead_reckoning')
        self.odom_pub = self.create_publisher(Odometry, 'odom', 10)
        self.path = Path()
        self.x = 0.0
        self.last_time = self.get_clock().now()
        self.odom_sub = self.create_subscription(Odometry, 'odom', self.odom_callback, 10)
        self.timer = self.create_timer(0.02, self.step)

    def step(self):
        now = self.get_clock().now()
        dt = (now - self.last_time).nanoseconds / 1e9
        self.last_time = now
        self.x += 1.0 * dt
        odom = Odometry()
        odom.header.stamp = now.to_msg()
        odom.header.frame_id = 'odom'
        odom.pose.pose.position.x = self.x
        odom.pose.pose.orientation = Quaternion(x=0.0, y=0.0, z=math.sin(0.1), w=math.cos(0.1))
        odom.twist.twist = Twist(linear=Vector3(x=1.0))
        odom.pose.covariance[0] = 0.1
        self.odom_pub.publish(odom)

    def odom_callback(self, msg):
        self.path.poses.append(PoseStamped(header=msg.header, pose=msg.pose.pose))
        if len(self.path.poses) == 10:
            self.get_logger().info(f'path of {len(self.path.poses)} to {msg.pose.pose.position.x > 0}')


rclpy.init()
rclpy.spin(DeadReckoning())
