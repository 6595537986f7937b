from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_launch_description():
    speed = LaunchConfiguration('speed')
    return LaunchDescription([
        DeclareLaunchArgument('speed', default_value='1.0', description='in m/s'),
        DeclareLaunchArgument('talk', default_value='true', choices=['true', 'false']),
        LogInfo(msg=['the speed is ', speed]),
        LogInfo(msg='fast', condition=IfCondition(PythonExpression([speed, ' > 1.5']))),
        Node(package='demo_nodes_py', executable='talker',
             condition=IfCondition(LaunchConfiguration('talk'))),
        LogInfo(msg='silence', condition=UnlessCondition(LaunchConfiguration('talk'))),
    ])
