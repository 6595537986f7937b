"""Simulate a world of Gazebo without a view. The arguments are those of the genuine ros_gz_sim."""

from pathlib import Path
from tempfile import mkdtemp

from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def start(context: LaunchContext) -> list[Node]:
    """Return the simulator of a file or of a text."""
    file, text = (
        LaunchConfiguration(name).perform(context)
        for name in ("world_sdf_file", "world_sdf_string")
    )
    if text and not file:
        path = Path(mkdtemp(), "world.sdf")
        path.write_text(text, encoding="utf-8")
        file = str(path)
    words = ["sim", "-r", "-s", *([file] if file else [])]
    return [Node(package="gz_sim", executable="gz", arguments=words, output="screen")]


def generate_launch_description() -> LaunchDescription:
    """Return the simulator."""
    names = ("world_sdf_file", "world_sdf_string")
    unused = ("container_name", "create_own_container", "use_composition")
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value="") for name in names),
            *(DeclareLaunchArgument(name, default_value="False") for name in unused),
            OpaqueFunction(function=start),
        ]
    )
