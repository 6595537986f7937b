"""Publish a robot description of a package. The arguments are those of the genuine urdf_launch."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description() -> LaunchDescription:
    """Return the node that publishes the description and its frames."""
    package, path = LaunchConfiguration("urdf_package"), LaunchConfiguration("urdf_package_path")
    file = PathJoinSubstitution([FindPackageShare(package), path])
    description = ParameterValue(Command(["xacro ", file]), value_type=str)
    return LaunchDescription(
        [
            DeclareLaunchArgument("urdf_package", description="The package of the description"),
            DeclareLaunchArgument("urdf_package_path", description="The file in the package"),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": description}],
            ),
        ]
    )
