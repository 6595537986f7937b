"""Add a robot and connect its topics. The arguments are those of the genuine ros_gz_sim."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    """Return the program that adds the robot, and the bridge."""
    files = (
        ("ros_gz_sim", "gz_spawn_model.launch.py"),
        ("ros_gz_bridge", "ros_gz_bridge.launch.py"),
    )
    return LaunchDescription(
        [
            DeclareLaunchArgument("config_file", default_value=""),
            DeclareLaunchArgument("bridge_name", default_value="ros_gz_bridge"),
            *(
                IncludeLaunchDescription(
                    PathJoinSubstitution([FindPackageShare(package), "launch", file])
                )
                for package, file in files
            ),
        ]
    )
