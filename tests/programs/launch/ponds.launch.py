"""Two ponds of turtles; those of the second follow those of the first."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    return LaunchDescription(
        [
            DeclareLaunchArgument("follow", default_value="true"),
            *(
                Node(package="turtlesim", executable="turtlesim_node", namespace=pond, name="water")
                for pond in ("north", "south")
            ),
            Node(
                package="turtlesim",
                executable="mimic",
                name="ripple",
                condition=IfCondition(LaunchConfiguration("follow")),
                remappings=[
                    ("input/pose", "/north/turtle1/pose"),
                    ("output/cmd_vel", "/south/turtle1/cmd_vel"),
                ],
            ),
        ]
    )
