"""Show a robot description, with sliders. The arguments are those of the genuine urdf_launch."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

DESCRIPTION = str(Path(__file__).with_name("description.launch.py"))


def generate_launch_description() -> LaunchDescription:
    """Return the description, the joints and the viewer."""
    has_sliders = LaunchConfiguration("jsp_gui")
    names = ("urdf_package", "urdf_package_path")
    return LaunchDescription(
        [
            DeclareLaunchArgument("urdf_package", description="The package of the description"),
            DeclareLaunchArgument("urdf_package_path", description="The file in the package"),
            DeclareLaunchArgument("jsp_gui", default_value="true", choices=["true", "false"]),
            DeclareLaunchArgument("rviz_config", default_value=""),
            IncludeLaunchDescription(
                DESCRIPTION,
                launch_arguments={name: LaunchConfiguration(name) for name in names}.items(),
            ),
            Node(
                package="joint_state_publisher",
                executable="joint_state_publisher",
                condition=UnlessCondition(has_sliders),
            ),
            Node(
                package="joint_state_publisher_gui",
                executable="joint_state_publisher_gui",
                condition=IfCondition(has_sliders),
            ),
            Node(
                package="rviz2",
                executable="rviz2",
                arguments=["-d", LaunchConfiguration("rviz_config")],
            ),
        ]
    )
