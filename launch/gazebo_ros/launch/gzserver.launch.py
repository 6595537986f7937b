"""Simulate a world of Gazebo Classic. The arguments are those of the genuine gazebo_ros."""

import shlex

from launch import LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction, Shutdown
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

UNUSED = (
    *("verbose", "lockstep", "record", "minimal_comms", "init", "factory", "force_system"),
    *("debug", "gdb", "valgrind", "physics", "profile", "params_file", "version", "help"),
    *("record_encoding", "record_path", "record_period", "record_filter", "iters", "play"),
)


def start(context: LaunchContext) -> list[Node]:
    """Return the simulator of the world."""
    names = ("world", "seed", "pause", "extra_gazebo_args", "server_required")
    world, seed, pause, extra, ends_launch = (
        LaunchConfiguration(name).perform(context) for name in names
    )
    words = [world] if world else []
    words += ["--seed", seed] if seed else []
    words += ["-u"] if pause.lower() in {"true", "1"} else []
    return [
        Node(
            package="gazebo",
            executable="gzserver",
            arguments=[*words, *shlex.split(extra)],
            output="screen",
            on_exit=[Shutdown()] if ends_launch.lower() in {"true", "1"} else None,
        )
    ]


def generate_launch_description() -> LaunchDescription:
    """Return the simulator."""
    return LaunchDescription(
        [
            DeclareLaunchArgument("world", default_value="", description="The file of the world"),
            DeclareLaunchArgument("seed", default_value="", description="The seed of the noise"),
            DeclareLaunchArgument("pause", default_value="false", description="Start paused"),
            DeclareLaunchArgument("extra_gazebo_args", default_value="", description="More words"),
            DeclareLaunchArgument(
                "server_required",
                default_value="false",
                description="Whether the launch ends when the simulator ends",
            ),
            *(
                DeclareLaunchArgument(name, default_value="", description="Has no effect")
                for name in UNUSED
            ),
            OpaqueFunction(function=start),
        ]
    )
