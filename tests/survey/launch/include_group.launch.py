import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution, ThisLaunchFileDir
from launch_ros.actions import PushRosNamespace


def generate_launch_description():
    here = os.path.dirname(os.path.abspath(__file__))
    return LaunchDescription([
        GroupAction(actions=[
            PushRosNamespace('robot1'),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(
                    PathJoinSubstitution([ThisLaunchFileDir(), 'talker_listener.launch.py']))),
        ]),
        GroupAction(actions=[
            PushRosNamespace('robot2'),
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource(os.path.join(here, 'arguments.launch.py')),
                launch_arguments={'speed': '2.0'}.items()),
        ]),
    ])
