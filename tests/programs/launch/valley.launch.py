"""Two orchards of one file, each in a group with its own namespace and argument."""

from launch import LaunchDescription
from launch.actions import GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import PushRosNamespace


def orchard(name: str, rows: int) -> GroupAction:
    path = PathJoinSubstitution([ThisLaunchFileDir(), "orchard.launch.py"])
    source = PythonLaunchDescriptionSource(path)
    included = IncludeLaunchDescription(source, launch_arguments={"rows": str(rows)}.items())
    return GroupAction([PushRosNamespace(name), included])


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription([orchard("sunny", 3), orchard("shady", 1)])
