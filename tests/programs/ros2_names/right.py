"""Program with names that exist. A type checker must report nothing."""

import launch
import launch.logging
import rclpy
import rosbag2_py
import tf2_ros
from cv_bridge import CvBridge
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.actions.timer_action import TimerAction
from launch_ros.actions import Node as NodeAction
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from rosidl_runtime_py import get_interfaces
from tf2_ros import Buffer, BufferClient

from std_msgs.msg import String


class Talker(Node):
    def __init__(self) -> None:
        super().__init__("talker")
        self.publisher = self.create_publisher(String, "chatter", qos_profile_sensor_data)
        self.broadcaster = tf2_ros.transform_broadcaster.TransformBroadcaster(self)
        self.client = BufferClient(self, "buffer")


def generate_launch_description() -> LaunchDescription:
    launch.logging.get_logger("right").info("hello")
    actions = [launch.actions.TimerAction(period=1.0, actions=[]), NodeAction(executable="talker")]
    return LaunchDescription([DeclareLaunchArgument("name"), *actions])


rclpy.init()
rclpy.spin(Talker())
print(rclpy.qos.QoSProfile(depth=1), QoSProfile(depth=2), Buffer(), CvBridge(), TimerAction)
print(rosbag2_py.SequentialReader(), get_interfaces(), rclpy_implementation.RCLError)
