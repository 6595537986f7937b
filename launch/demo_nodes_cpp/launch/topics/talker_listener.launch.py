"""A talker and a listener, at the path that the tutorials of ROS 2 up to Humble include.

Run: zbot launch demo_nodes_cpp talker_listener.launch.py
"""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return the talker and the listener."""
    names = ("talker", "listener")
    return LaunchDescription(
        [Node(package="demo_nodes_cpp", executable=name, output="screen") for name in names]
    )
