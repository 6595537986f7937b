"""The launch's own node, which actions use to communicate with other nodes."""

from zbot.launch.ros_node import LaunchNode as ROSAdapter
from zbot.launch.ros_node import get_ros_node
from zbot.launch.ros_node import launch_node as get_ros_adapter

__all__ = ["ROSAdapter", "get_ros_adapter", "get_ros_node"]
