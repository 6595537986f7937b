from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def launch_setup(context, *args, **kwargs):
    count = int(LaunchConfiguration('count').perform(context))
    return [Node(package='demo_nodes_py', executable='talker', name=f'talker_{i}')
            for i in range(count)] + [LogInfo(msg=f'{count} talkers')]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('count', default_value='2'),
        OpaqueFunction(function=launch_setup),
    ])
