"""Add a robot to the simulator. The arguments are those of the genuine ros_gz_sim."""

from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

OPTIONS = {
    "world": "world",
    "file": "file",
    "model_string": "string",
    "xml_string": "string",
    "topic": "topic",
    "entity_name": "name",
    "allow_renaming": "allow_renaming",
    **{name: name for name in ("x", "y", "z", "R", "P", "Y")},
    "roll": "R",
    "pitch": "P",
    "yaw": "Y",
}


def start(context: LaunchContext) -> list[Node]:
    """Return the program that adds the robot."""
    words: list[str] = []
    for name, option in OPTIONS.items():
        value = LaunchConfiguration(name).perform(context)
        words += [f"-{option}", value] if value else []
    return [Node(package="ros_gz_sim", executable="create", arguments=words, output="screen")]


def generate_launch_description() -> LaunchDescription:
    """Return the program that adds the robot."""
    names = [DeclareLaunchArgument(name, default_value="") for name in OPTIONS]
    return LaunchDescription([*names, OpaqueFunction(function=start)])
