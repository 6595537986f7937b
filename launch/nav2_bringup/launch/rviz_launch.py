"""Show the robot, the map and the path. The arguments are those of the genuine nav2_bringup."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, Shutdown
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

ARGUMENTS = {
    "namespace": "",
    "rviz_config": str(Path(__file__).parents[1] / "rviz" / "nav2_default_view.rviz"),
    "use_sim_time": "false",
}
#: An argument of Nav2's file that changes nothing here: an empty namespace says the same.
WITHOUT_EFFECT = "use_namespace"
FRAMES = [("/tf", "tf"), ("/tf_static", "tf_static")]


def generate_launch_description() -> LaunchDescription:
    """Return the viewer. The launch ends with it."""
    simulated = ParameterValue(LaunchConfiguration("use_sim_time"), value_type=bool)
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value=text) for name, text in ARGUMENTS.items()),
            DeclareLaunchArgument(WITHOUT_EFFECT, default_value=""),
            Node(
                package="rviz2",
                executable="rviz2",
                namespace=LaunchConfiguration("namespace"),
                arguments=["-d", LaunchConfiguration("rviz_config")],
                parameters=[{"use_sim_time": simulated}],
                remappings=FRAMES,
                on_exit=Shutdown(reason="rviz exited"),
                output="screen",
            ),
        ]
    )
