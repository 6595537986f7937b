"""Show the 3D view of the simulator. The arguments are those of the genuine gazebo_ros."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node

UNUSED = (
    *("version", "verbose", "help", "extra_gazebo_args", "gdb", "debug", "valgrind"),
    *("gui_required", "gui_plugins"),
)


def generate_launch_description() -> LaunchDescription:
    """Return the view."""
    return LaunchDescription(
        [
            *(
                DeclareLaunchArgument(name, default_value="", description="Has no effect")
                for name in UNUSED
            ),
            Node(package="gazebo", executable="gzclient", output="screen"),
        ]
    )
