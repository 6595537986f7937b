import os
from tempfile import gettempdir

from launch import LaunchDescription
from launch.substitutions import TextSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    path = os.path.join(gettempdir(), f'zbot_survey_{os.getpid()}.yaml')
    with open(path, 'w') as file:
        file.write('/**:\n  ros__parameters:\n    driver: Grace\n')
    return LaunchDescription([
        Node(
            package='zbot_nodes',
            executable='parameter_demo',
            name='demo',
            parameters=[path, {'speed': 1.25, 'laps': 2}],
        ),
    ])
