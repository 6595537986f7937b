"""Simulated robot: base, laser, inertial sensor, camera, navigation and appearance.

Run: zbot launch zbot_nodes robot.launch.py
     zbot launch zbot_nodes robot.launch.py patrol:=false     (it waits for goals and commands)
"""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

APPEARANCE = Path(__file__).with_name("robot.urdf")


def generate_launch_description() -> LaunchDescription:
    """Return the robot's six nodes."""
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
    appearance = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        output="screen",
        parameters=[{"robot_description": APPEARANCE.read_text(encoding="utf-8")}],
    )
    return LaunchDescription([patrol, *parts, navigation, appearance])
