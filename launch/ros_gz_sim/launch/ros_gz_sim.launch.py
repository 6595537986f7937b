"""Simulate a world and connect its topics. The arguments are those of the genuine ros_gz_sim."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    """Return the simulator and the bridge."""
    files = (("ros_gz_sim", "gz_server.launch.py"), ("ros_gz_bridge", "ros_gz_bridge.launch.py"))
    return LaunchDescription(
        [
            DeclareLaunchArgument("config_file", default_value=""),
            DeclareLaunchArgument("bridge_name", default_value="ros_gz_bridge"),
            DeclareLaunchArgument("world_sdf_file", default_value=""),
            DeclareLaunchArgument("world_sdf_string", default_value=""),
            *(
                IncludeLaunchDescription(
                    PathJoinSubstitution([FindPackageShare(package), "launch", file])
                )
                for package, file in files
            ),
        ]
    )
