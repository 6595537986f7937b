"""Simulate a world of Gazebo with zbot. The arguments are those of the genuine ros_gz_sim."""

import shlex

from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, Shutdown
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def start(context: LaunchContext) -> list[Node]:
    """Return the simulator with the words of `gz_args`."""
    values = {
        name: LaunchConfiguration(name).perform(context)
        for name in ("gz_args", "ign_args", "on_exit_shutdown")
    }
    words = shlex.split(values["gz_args"] or values["ign_args"])
    ends_launch = values["on_exit_shutdown"].lower() in {"true", "1"}
    return [
        Node(
            package="gz_sim",
            executable="gz",
            exec_name="gazebo",
            arguments=["sim", *words],
            output="screen",
            on_exit=[Shutdown()] if ends_launch else None,
        )
    ]


def generate_launch_description() -> LaunchDescription:
    """Return the simulator."""
    return LaunchDescription(
        [
            DeclareLaunchArgument("gz_args", default_value="", description="Words for Gazebo"),
            DeclareLaunchArgument("gz_version", default_value="8", description="Has no effect"),
            DeclareLaunchArgument("ign_args", default_value="", description="Old gz_args"),
            DeclareLaunchArgument("ign_version", default_value="", description="Has no effect"),
            DeclareLaunchArgument("debugger", default_value="false", description="Has no effect"),
            DeclareLaunchArgument("debug_env", default_value="false", description="Has no effect"),
            DeclareLaunchArgument(
                "on_exit_shutdown",
                default_value="false",
                description="Whether the launch ends when the simulator ends",
            ),
            OpaqueFunction(function=start),
        ]
    )
