"""Start the planner, the controller and what else drives a robot to goals."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace, SetParameter
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
from nav2_common.launch import RewrittenYaml

PARAMETERS = str(Path(__file__).parents[1] / "params" / "nav2_params.yaml")
ARGUMENTS = {
    "namespace": "",
    "use_sim_time": "false",
    "autostart": "true",
    "params_file": PARAMETERS,
    "use_respawn": "False",
    "log_level": "info",
}
#: Arguments of Nav2's file that change nothing here: each node is a process of its own.
WITHOUT_EFFECT = ("use_composition", "container_name", "graph")
TO_SMOOTHER = [("cmd_vel", "cmd_vel_nav")]
NODES = (
    ("nav2_controller", "controller_server", TO_SMOOTHER),
    ("nav2_smoother", "smoother_server", []),
    ("nav2_planner", "planner_server", []),
    ("nav2_behaviors", "behavior_server", TO_SMOOTHER),
    ("nav2_bt_navigator", "bt_navigator", []),
    ("nav2_waypoint_follower", "waypoint_follower", []),
    ("nav2_velocity_smoother", "velocity_smoother", TO_SMOOTHER),
    ("nav2_collision_monitor", "collision_monitor", []),
)
FRAMES = [("/tf", "tf"), ("/tf_static", "tf_static")]


def generate_launch_description() -> LaunchDescription:
    """Return the nodes and their manager."""
    given = {name: LaunchConfiguration(name) for name in ARGUMENTS}
    rewritten = RewrittenYaml(
        source_file=given["params_file"],
        root_key=given["namespace"],
        param_rewrites={"autostart": given["autostart"]},
        convert_types=True,
    )
    parameters = ParameterFile(rewritten, allow_substs=True)
    level = ["--ros-args", "--log-level", given["log_level"]]
    nodes = [
        Node(
            package=package,
            executable=name,
            name=name,
            output="screen",
            respawn=given["use_respawn"],
            parameters=[parameters],
            arguments=level,
            remappings=[*FRAMES, *remappings],
        )
        for package, name, remappings in NODES
    ]
    manager = Node(
        package="nav2_lifecycle_manager",
        executable="lifecycle_manager",
        name="lifecycle_manager_navigation",
        output="screen",
        parameters=[
            {"autostart": ParameterValue(given["autostart"], value_type=bool)},
            {"node_names": [name for _, name, _ in NODES]},
        ],
        arguments=level,
    )
    simulated = ParameterValue(given["use_sim_time"], value_type=bool)
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value=text) for name, text in ARGUMENTS.items()),
            *(DeclareLaunchArgument(name, default_value="") for name in WITHOUT_EFFECT),
            GroupAction(
                [
                    PushROSNamespace(given["namespace"]),
                    SetParameter("use_sim_time", simulated),
                    *nodes,
                    manager,
                ]
            ),
        ]
    )
