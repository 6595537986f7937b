"""Make a map while the robot drives. The arguments are those of the genuine slam_toolbox."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration

CONFIG = Path(get_package_share_directory("slam_toolbox"), "config")
ARGUMENTS = {
    "use_sim_time": "true",
    "slam_params_file": str(CONFIG / "mapper_params_online_sync.yaml"),
}


def generate_launch_description() -> LaunchDescription:
    """Return the mapper: it uses each scan in its turn, as the file for online_async does."""
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value=text) for name, text in ARGUMENTS.items()),
            IncludeLaunchDescription(
                str(Path(__file__).with_name("online_async_launch.py")),
                launch_arguments=[(name, LaunchConfiguration(name)) for name in ARGUMENTS],
            ),
        ]
    )
