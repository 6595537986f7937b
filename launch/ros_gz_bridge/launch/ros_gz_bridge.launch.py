"""Connect topics of the simulator. The arguments are those of the genuine ros_gz_bridge."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """Return the bridge."""
    unused = ("container_name", "create_own_container", "use_composition", "use_respawn")
    return LaunchDescription(
        [
            DeclareLaunchArgument("bridge_name", default_value="ros_gz_bridge"),
            DeclareLaunchArgument("config_file", default_value=""),
            DeclareLaunchArgument("namespace", default_value=""),
            DeclareLaunchArgument("log_level", default_value="info"),
            *(DeclareLaunchArgument(name, default_value="False") for name in unused),
            Node(
                package="ros_gz_bridge",
                executable="parameter_bridge",
                name=LaunchConfiguration("bridge_name"),
                namespace=LaunchConfiguration("namespace"),
                parameters=[{"config_file": LaunchConfiguration("config_file")}],
                arguments=["--ros-args", "--log-level", LaunchConfiguration("log_level")],
                output="screen",
            ),
        ]
    )
