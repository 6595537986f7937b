"""Launch file: it starts two programs together, one of them with another name and another topic.

Run: zbot launch examples/publisher_subscriber.launch.py topic:=news
"""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

SUBSCRIBER = str(Path(__file__).parent / "subscriber.py")


def generate_launch_description() -> LaunchDescription:
    topic = LaunchConfiguration("topic")
    return LaunchDescription(
        [
            DeclareLaunchArgument("topic", default_value="chatter", description="Their topic"),
            # A node of a package.
            Node(
                package="demo_nodes_py",
                executable="talker",
                name="speaker",
                remappings=[("chatter", topic)],
            ),
            # A program that belongs to no package.
            ExecuteProcess(
                cmd=["python3", SUBSCRIBER, "--ros-args", "-r", ["chatter:=", topic]],
                output="screen",
            ),
        ]
    )
