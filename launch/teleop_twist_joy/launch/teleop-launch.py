"""Drive with a gamepad. The arguments are those of the genuine teleop_twist_joy."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue

CONFIG = Path(__file__).parents[1] / "config"


def generate_launch_description() -> LaunchDescription:
    """Return the gamepad and the node that turns it into velocities."""
    names = [LaunchConfiguration(name) for name in ("joy_vel", "joy_dev", "config_filepath")]
    topic, device, path = names
    stamped = LaunchConfiguration("publish_stamped_twist")
    default = [f"{CONFIG}/", LaunchConfiguration("joy_config"), ".config.yaml"]
    joy = {"device_id": ParameterValue(device, value_type=int), "deadzone": 0.3}
    return LaunchDescription(
        [
            DeclareLaunchArgument("joy_vel", default_value="cmd_vel"),
            DeclareLaunchArgument("joy_config", default_value="ps3"),
            DeclareLaunchArgument("joy_dev", default_value="0"),
            DeclareLaunchArgument("publish_stamped_twist", default_value="false"),
            DeclareLaunchArgument("config_filepath", default_value=default),
            Node(
                package="joy",
                executable="joy_node",
                name="joy_node",
                parameters=[{**joy, "autorepeat_rate": 20.0}],
            ),
            Node(
                package="teleop_twist_joy",
                executable="teleop_node",
                name="teleop_twist_joy_node",
                parameters=[
                    ParameterFile(path),
                    {"publish_stamped_twist": ParameterValue(stamped, value_type=bool)},
                ],
                remappings=[("/cmd_vel", topic)],
            ),
        ]
    )
