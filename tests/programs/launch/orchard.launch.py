"""As many thermometers as an argument says, with the parameters of a file."""

from pathlib import Path

from launch import LaunchContext, LaunchDescription, LaunchDescriptionEntity
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import (
    LaunchConfiguration,
    PathJoinSubstitution,
    PythonExpression,
    ThisLaunchFileDir,
)
from launch_ros.actions import Node

ROWS = LaunchConfiguration("rows")
ROOF = str(Path(__file__).parents[1] / "greenhouse_roof.py")


def thermometers(context: LaunchContext) -> list[LaunchDescriptionEntity]:
    return [
        Node(package="zbot", executable="sensor", name=f"row_{row}")
        for row in range(int(ROWS.perform(context)))
    ]


def generate_launch_description() -> LaunchDescription:
    many = PythonExpression([ROWS, " > 2"])
    return LaunchDescription(
        [
            DeclareLaunchArgument("rows", default_value="1", description="rows of trees"),
            LogInfo(msg=["an orchard of ", ROWS], condition=IfCondition(many)),
            LogInfo(msg=["a garden of ", ROWS], condition=UnlessCondition(many)),
            OpaqueFunction(function=thermometers),
            Node(
                executable=["zbot"],
                arguments=["run", ROOF],
                name="shed",
                parameters=[
                    PathJoinSubstitution([ThisLaunchFileDir(), "shed.yaml"]),
                    {"panes": ROWS, "open_at": 30.5},
                ],
            ),
        ]
    )
