import launch_ros
from launch import LaunchDescription
from launch.actions import SetEnvironmentVariable


def generate_launch_description():
    return LaunchDescription([
        SetEnvironmentVariable('RCUTILS_COLORIZED_OUTPUT', '0'),
        launch_ros.actions.Node(
            package='tf2_ros', executable='static_transform_publisher', name='base_to_laser',
            arguments=['0', '0', '0.2', '0', '0', '0', 'base_link', 'laser']),
        launch_ros.actions.Node(
            package='tf2_ros', executable='tf2_echo', arguments=['base_link', 'laser'], output='screen'),
    ])
