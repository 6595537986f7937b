import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class GoToGoal(Node):
    def __init__(self):
        super().__init__('go_to_goal')
        self.cmd_vel_pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.pose_callback, 10)
        self.pose = None
        self.timer = self.create_timer(0.02, self.control)

    def pose_callback(self, data):
        self.pose = data
        self.pose.x = round(self.pose.x, 4)

    def control(self):
        if self.pose is None:
            return
        dx, dy = 7.0 - self.pose.x, 7.0 - self.pose.y
        distance = math.sqrt(dx ** 2 + dy ** 2)
        msg = Twist()
        if distance > 0.1:
            msg.linear.x = 1.5 * distance
            diff = math.atan2(dy, dx) - self.pose.theta
            msg.angular.z = 6.0 * math.atan2(math.sin(diff), math.cos(diff))
        else:
            self.get_logger().info('Goal reached', once=True)
        self.cmd_vel_pub.publish(msg)


def main():
    rclpy.init()
    rclpy.spin(GoToGoal())


if __name__ == '__main__':
    main()
