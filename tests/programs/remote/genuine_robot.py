"""Robot of a genuine ROS 2: it publishes its battery and prints the speeds that it is told."""

import contextlib

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import BatteryState
from std_srvs.srv import Trigger


def main():
    rclpy.init(args=[])
    node = rclpy.create_node("base")
    publisher = node.create_publisher(BatteryState, "battery", 10)
    node.create_timer(0.1, lambda: publisher.publish(BatteryState(percentage=0.75)))
    node.create_subscription(Twist, "cmd_vel", lambda message: print("speed", message.linear.x), 10)

    def beep(request, response):
        response.success, response.message = True, "beep"
        return response

    node.create_service(Trigger, "beep", beep)
    print("the robot is on")
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(node)


if __name__ == "__main__":
    main()
