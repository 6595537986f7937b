"""Choose between sources of velocities. The arguments are those of the genuine twist_mux."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

CONFIG = Path(__file__).parents[1] / "config"


def generate_launch_description() -> LaunchDescription:
    """Return the node with its sources and locks."""
    locks, topics = str(CONFIG / "twist_mux_locks.yaml"), str(CONFIG / "twist_mux_topics.yaml")
    return LaunchDescription(
        [
            DeclareLaunchArgument("config_locks", default_value=locks),
            DeclareLaunchArgument("config_topics", default_value=topics),
            DeclareLaunchArgument("cmd_vel_out", default_value="twist_mux/cmd_vel"),
            DeclareLaunchArgument("use_sim_time", default_value="False"),
            Node(
                package="twist_mux",
                executable="twist_mux",
                output="screen",
                remappings=[("/cmd_vel_out", LaunchConfiguration("cmd_vel_out"))],
                parameters=[
                    {"use_sim_time": LaunchConfiguration("use_sim_time")},
                    LaunchConfiguration("config_locks"),
                    LaunchConfiguration("config_topics"),
                ],
            ),
        ]
    )
