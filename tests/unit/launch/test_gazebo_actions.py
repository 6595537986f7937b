"""Tests of the actions of `ros_gz_bridge` and `ros_gz_sim`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.actions import IncludeLaunchDescription, Node
from zbot.launch.actions.gazebo import GzServer, GzSpawnModel, RosGzBridge
from zbot.launch.errors import LaunchUsageError
from zbot.launch.substitution import perform
from zbot.package import package_share

if TYPE_CHECKING:
    from pathlib import Path


def nodes(entities: Any, context: LaunchContext) -> list[Node]:
    """Return the nodes below entities, and execute all other actions."""
    found: list[Node] = []
    for entity in entities or ():
        if isinstance(entity, Node):
            found.append(entity)
        else:
            found += nodes(entity.visit(context), context)
    return found


def arguments(made: Any, context: LaunchContext) -> list[str]:
    return [context.perform_substitution(part) for part in made]


def test_the_bridge_and_the_server_start_zbots_programs() -> None:
    context = LaunchContext()
    context.launch_configurations["namespace"] = "outside"
    bridge = RosGzBridge(bridge_name="link", config_file="/x.yaml", create_own_container=True)
    server = GzServer(world_sdf_file="empty.sdf", use_composition="True")
    found = [arguments(one.executable, context) for one in nodes([bridge, server], context)]
    assert found == [["parameter_bridge"], ["gz"]]
    assert context.launch_configurations["namespace"] == "outside"


def test_a_model_is_spawned_with_its_place(tmp_path: Path) -> None:
    context = LaunchContext()
    expected = ["-world", "w", "-topic", "/robot_description", "-name", "r", "-z", "0.1", "-Y", "2"]
    given: dict[str, Any] = {
        "world": "w",
        "topic": "/robot_description",
        "entity_name": "r",
        "z": "0.1",
    }
    (program,) = nodes([GzSpawnModel(**given, yaw="2")], context)
    assert [perform(context, word) for word in program.arguments] == expected
    words = " ".join(f'{name}="{value}"' for name, value in given.items())
    path = tmp_path / "a.launch.xml"
    path.write_text(f'<launch><gz_spawn_model {words} yaw="2"/></launch>')
    (program,) = nodes([IncludeLaunchDescription(str(path))], context)
    assert [perform(context, word) for word in program.arguments] == expected


@pytest.mark.parametrize(
    ("package", "name", "given"),
    [
        ("ros_gz_sim", "gz_spawn_model", {"topic": "/x"}),
        ("ros_gz_sim", "gz_server", {"world_sdf_file": "empty.sdf"}),
        ("ros_gz_bridge", "ros_gz_bridge", {"bridge_name": "link", "config_file": "/x.yaml"}),
    ],
)
def test_a_launch_file_in_xml_has_the_arguments_of_the_one_in_python(
    package: str, name: str, given: dict[str, str]
) -> None:
    file = f"{package_share(package)}/launch/{name}.launch"
    context = LaunchContext()
    (program,) = nodes([IncludeLaunchDescription(file, launch_arguments=given.items())], context)
    assert perform(context, program.package or "") in {"gz_sim", package}


def test_an_argument_without_effect_is_named(capfd: pytest.CaptureFixture[str]) -> None:
    RosGzBridge(bridge_name="link", config_file="/x.yaml", bridge_params="a: 1")
    assert "RosGzBridge: bridge_params has no effect in zbot" in capfd.readouterr().err


def test_an_unknown_argument_is_refused() -> None:
    with pytest.raises(LaunchUsageError, match="has no argument 'world'; it has world_sdf_file"):
        GzServer(world="empty.sdf")
