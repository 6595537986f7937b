"""Make a map while the robot drives. The arguments are those of the genuine slam_toolbox."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

KIND = "async" if "async" in Path(__file__).name else "sync"
CONFIG = Path(get_package_share_directory("slam_toolbox"), "config")
ARGUMENTS = {
    "use_sim_time": "true",
    "slam_params_file": str(CONFIG / f"mapper_params_online_{KIND}.yaml"),
}
#: Arguments that change nothing here: the node starts itself if no other program does.
WITHOUT_EFFECT = {"autostart": "true", "use_lifecycle_manager": "false"}


def generate_launch_description() -> LaunchDescription:
    """Return the mapper."""
    arguments = {**ARGUMENTS, **WITHOUT_EFFECT}
    simulated = ParameterValue(LaunchConfiguration("use_sim_time"), value_type=bool)
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value=text) for name, text in arguments.items()),
            Node(
                package="slam_toolbox",
                executable=f"{KIND}_slam_toolbox_node",
                name="slam_toolbox",
                output="screen",
                parameters=[LaunchConfiguration("slam_params_file"), {"use_sim_time": simulated}],
            ),
        ]
    )
