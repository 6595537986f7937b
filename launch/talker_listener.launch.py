"""A talker and a listener, optionally in a namespace.

Run: zbot launch talker_listener
     zbot launch talker_listener namespace:=demo
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return the talker and the listener."""
    namespace = LaunchConfiguration("namespace")
    return LaunchDescription(
        [
            DeclareLaunchArgument(
                "namespace", default_value="", description="Namespace of both nodes"
            ),
            Node(package="zbot", executable="talker", namespace=namespace),
            Node(package="zbot", executable="listener", namespace=namespace),
        ]
    )
