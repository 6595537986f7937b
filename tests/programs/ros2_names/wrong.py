"""Program with names that do not exist. A type checker must report each line with `wrong`."""
# ruff: noqa: F401, B018

import launch
import launch.logging
import rclpy
import rclpy.nodes  # wrong
import tf2_ros
from launch.actions import DeclareLaunchArgumen  # wrong
from rclpy import spinn  # wrong
from rclpy.node import Nod  # wrong
from rosidl_runtime_py import get_interface_names  # wrong

from std_msgs.msg import Strng  # wrong

rclpy.spinn()  # wrong
rclpy.qos.Profile  # wrong
tf2_ros.Bufer  # wrong
launch.actionss  # wrong
launch.logging.get_loger("wrong")  # wrong
