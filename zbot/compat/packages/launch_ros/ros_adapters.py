"""The launch's own node, for actions that talk to others."""

from zbot.launch.ros_node import LaunchNode as ROSAdapter
from zbot.launch.ros_node import get_ros_node as get_ros_node
from zbot.launch.ros_node import launch_node as get_ros_adapter

__all__ = ["ROSAdapter", "get_ros_adapter", "get_ros_node"]
