"""Wrong imports from ROS 2's packages say what to write."""

from __future__ import annotations

import importlib.util

import pytest

import zbot.compat  # noqa: F401 - makes `import rclpy` work
import zbot_ros2_names
from zbot.compat import missing_name


@pytest.mark.parametrize(
    ("statement", "text"),
    [
        ("from rclpy import Node", "write from rclpy.node import Node$"),
        ("import rclpy.Node", "write from rclpy.node import Node$"),
        ("from rclpy.Node import Node", "write from rclpy.node import Node$"),
        ("from rclpy.nodes import Node", "did you mean 'rclpy.node'"),
        ("from rclpy.executor import SingleThreadedExecutor", "did you mean 'rclpy.executors'"),
        ("from rclpy import ActionServer", "write from rclpy.action import ActionServer$"),
        ("from rclpy.action import ActionSever", "write from rclpy.action import ActionServer$"),
        ("from rclpy import Duration", "write from rclpy.duration import Duration$"),
        ("from launch import IncludeLaunchDescription", "write from launch.actions import Include"),
        ("from tf2_ros import TransformBrodcaster", "import TransformBroadcaster$"),
        ("import rospy", "No module named 'rospy', which is of ROS 1: write import rclpy$"),
        ("from tf import TransformListener", "which is of ROS 1: write import tf2_ros$"),
        ("from message_filters import nothing_like_it", "from 'message_filters'$"),
    ],
)
def test_a_wrong_import_says_what_to_write(statement: str, text: str) -> None:
    with pytest.raises(ImportError, match=text):
        exec(statement, {})


def test_each_package_of_ros_1_that_starts_zbot_has_a_replacement() -> None:
    assert missing_name._OF_ROS_1.keys() == zbot_ros2_names._OF_ROS_1


def test_the_search_for_a_module_raises_nothing() -> None:
    assert importlib.util.find_spec("rclpy.nothing") is None
    with pytest.raises(ImportError, match=r"rclpy\._nothing"):
        importlib.import_module("rclpy._nothing")
