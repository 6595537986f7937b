"""Two nodes in separate processes: a temperature sensor, and a monitor that warns.

Run: zbot launch temperature
"""

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return the sensor and the monitor."""
    return LaunchDescription(
        [
            Node(package="zbot", executable="sensor", name="sensor"),
            Node(package="zbot", executable="monitor", name="monitor"),
        ]
    )
