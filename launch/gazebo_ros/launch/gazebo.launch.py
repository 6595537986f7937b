"""Simulate a world and show it. The arguments are those of the genuine gazebo_ros."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, ThisLaunchFileDir


def generate_launch_description() -> LaunchDescription:
    """Return the simulator and its view."""
    files = {"server": "gzserver.launch.py", "gui": "gzclient.launch.py"}
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value="true") for name in files),
            *(
                IncludeLaunchDescription(
                    [ThisLaunchFileDir(), "/", file],
                    condition=IfCondition(LaunchConfiguration(name)),
                )
                for name, file in files.items()
            ),
        ]
    )
