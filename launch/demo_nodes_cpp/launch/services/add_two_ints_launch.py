"""A service that adds two numbers, and a client that calls it with 2 and 3.

Run: zbot launch demo_nodes_cpp add_two_ints_launch.py
"""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return the server and the client."""
    names = ("add_two_ints_server", "add_two_ints_client")
    return LaunchDescription(
        [Node(package="demo_nodes_cpp", executable=name, output="screen") for name in names]
    )
