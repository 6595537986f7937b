"""Simulated robot: base, laser, inertial sensor, camera and navigation.

Run: zbot launch zbot_nodes robot.launch.py
     zbot launch zbot_nodes robot.launch.py patrol:=false     (it waits for goals and commands)
"""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return the robot's five nodes."""
    patrol = DeclareLaunchArgument(
        "patrol",
        default_value="true",
        choices=["true", "false"],
        description="Drive around the room until a goal is set",
    )
    parts = [
        Node(package="zbot_nodes", executable=f"robot_{part}", output="screen")
        for part in ("base", "laser", "imu", "camera")
    ]
    navigation = Node(
        package="zbot_nodes",
        executable="robot_navigation",
        output="screen",
        parameters=[{"patrol": LaunchConfiguration("patrol")}],
    )
    return LaunchDescription([patrol, *parts, navigation])
