"""Start the mapper, and the node that saves maps."""

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
    "params_file": PARAMETERS,
    "use_sim_time": "True",
    "autostart": "True",
    "use_respawn": "False",
    "log_level": "info",
}
NODES = (
    ("slam_toolbox", "sync_slam_toolbox_node", "slam_toolbox"),
    ("nav2_map_server", "map_saver_server", "map_saver"),
)


def generate_launch_description() -> LaunchDescription:
    """Return the nodes and their manager."""
    given = {name: LaunchConfiguration(name) for name in ARGUMENTS}
    rewritten = RewrittenYaml(
        source_file=given["params_file"],
        root_key=given["namespace"],
        param_rewrites={},
        convert_types=True,
    )
    parameters = ParameterFile(rewritten, allow_substs=True)
    nodes = [
        Node(
            package=package,
            executable=executable,
            name=name,
            output="screen",
            respawn=given["use_respawn"],
            parameters=[parameters],
            arguments=["--ros-args", "--log-level", given["log_level"]],
            remappings=[("/tf", "tf"), ("/tf_static", "tf_static")],
        )
        for package, executable, name in NODES
    ]
    manager = Node(
        package="nav2_lifecycle_manager",
        executable="lifecycle_manager",
        name="lifecycle_manager_slam",
        output="screen",
        parameters=[
            {"autostart": ParameterValue(given["autostart"], value_type=bool)},
            {"node_names": [name for _, _, name in NODES]},
        ],
    )
    simulated = ParameterValue(given["use_sim_time"], value_type=bool)
    return LaunchDescription(
        [
            *(DeclareLaunchArgument(name, default_value=text) for name, text in ARGUMENTS.items()),
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
