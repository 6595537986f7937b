"""Two simulators in separate namespaces: /turtlesim1/turtlesim and /turtlesim2/turtlesim.

Run:   zbot launch turtlesim multisim.launch.py
Drive: zbot run turtlesim turtle_teleop_key --ros-args -r __ns:=/turtlesim1
"""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return both simulators."""
    return LaunchDescription(
        [
            Node(
                package="turtlesim",
                executable="turtlesim_node",
                namespace=f"turtlesim{number}",
                output="screen",
            )
            for number in (1, 2)
        ]
    )
