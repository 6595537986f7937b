"""Start all of navigation: the mapper or the localiser, and what drives the robot to goals."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression

HERE = Path(__file__).parent
PARAMETERS = str(HERE.parent / "params" / "nav2_params.yaml")
COMMON = {
    "namespace": "",
    "use_sim_time": "false",
    "autostart": "true",
    "params_file": PARAMETERS,
    "use_respawn": "False",
    "log_level": "info",
}
OTHERS = {"slam": "False", "map": "", "use_localization": "True"}
#: Arguments of Nav2's file that change nothing here: each node is a process of its own.
WITHOUT_EFFECT = ("use_composition", "container_name", "use_namespace", "graph")


def generate_launch_description() -> LaunchDescription:
    """Return the included launch files."""
    slam, localization = (LaunchConfiguration(name) for name in ("slam", "use_localization"))
    given = [(name, LaunchConfiguration(name)) for name in COMMON]
    is_wanted = ["'", localization, "'.lower() == 'true'"]
    is_mapping = PythonExpression([*is_wanted, " and '", slam, "'.lower() == 'true'"])
    is_located = PythonExpression([*is_wanted, " and '", slam, "'.lower() != 'true'"])
    arguments = {**COMMON, **OTHERS, **dict.fromkeys(WITHOUT_EFFECT, "")}
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value=text) for name, text in arguments.items()),
            IncludeLaunchDescription(
                str(HERE / "slam_launch.py"),
                launch_arguments=given,
                condition=IfCondition(is_mapping),
            ),
            IncludeLaunchDescription(
                str(HERE / "localization_launch.py"),
                launch_arguments=[*given, ("map", LaunchConfiguration("map"))],
                condition=IfCondition(is_located),
            ),
            IncludeLaunchDescription(str(HERE / "navigation_launch.py"), launch_arguments=given),
        ]
    )
