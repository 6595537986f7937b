"""Program that is marked: a loop with a rate drives, and callbacks run in another thread."""

import threading

import rclpy

from geometry_msgs.msg import Twist

rclpy.init()
node = rclpy.create_node("loop")
publisher = node.create_publisher(Twist, "cmd_vel", 10)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
rate = node.create_rate(10)
while rclpy.ok():
    command = Twist()
    command.linear.x = 0.4
    publisher.publish(command)
    rate.sleep()
