"""Start the map server, and the localiser that finds the robot in the map."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import EqualsSubstitution, LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace, SetParameter
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
from nav2_common.launch import RewrittenYaml

PARAMETERS = str(Path(__file__).parents[1] / "params" / "nav2_params.yaml")
ARGUMENTS = {
    "namespace": "",
    "map": "",
    "use_sim_time": "false",
    "autostart": "true",
    "params_file": PARAMETERS,
    "use_respawn": "False",
    "log_level": "info",
}
#: Arguments of Nav2's file that change nothing here: each node is a process of its own.
WITHOUT_EFFECT = ("use_composition", "container_name")
FRAMES = [("/tf", "tf"), ("/tf_static", "tf_static")]
NODES = (("nav2_map_server", "map_server"), ("nav2_amcl", "amcl"))


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
    common = {
        "output": "screen",
        "respawn": given["use_respawn"],
        "arguments": ["--ros-args", "--log-level", given["log_level"]],
        "remappings": FRAMES,
    }
    # Without the argument, the file with parameters has the path of the map.
    has_no_map = EqualsSubstitution(given["map"], "")
    path = {"yaml_filename": ParameterValue(given["map"], value_type=str)}
    server = {"package": "nav2_map_server", "executable": "map_server", "name": "map_server"}
    manager = Node(
        package="nav2_lifecycle_manager",
        executable="lifecycle_manager",
        name="lifecycle_manager_localization",
        output="screen",
        parameters=[
            {"autostart": ParameterValue(given["autostart"], value_type=bool)},
            {"node_names": [name for _, name in NODES]},
        ],
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
                    Node(
                        **server,
                        **common,
                        parameters=[parameters],
                        condition=IfCondition(has_no_map),
                    ),
                    Node(
                        **server,
                        **common,
                        parameters=[parameters, path],
                        condition=UnlessCondition(has_no_map),
                    ),
                    Node(
                        package="nav2_amcl",
                        executable="amcl",
                        name="amcl",
                        **common,
                        parameters=[parameters],
                    ),
                    manager,
                ]
            ),
        ]
    )
