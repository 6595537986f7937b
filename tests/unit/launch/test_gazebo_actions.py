"""Tests of the actions of `ros_gz_bridge` and `ros_gz_sim`."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.launch import LaunchContext
from zbot.launch.actions import Node
from zbot.launch.actions.gazebo import GzServer, RosGzBridge
from zbot.launch.errors import LaunchUsageError


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


def test_an_argument_without_effect_is_named(capfd: pytest.CaptureFixture[str]) -> None:
    RosGzBridge(bridge_name="link", config_file="/x.yaml", bridge_params="a: 1")
    assert "RosGzBridge: bridge_params has no effect in zbot" in capfd.readouterr().err


def test_an_unknown_argument_is_refused() -> None:
    with pytest.raises(LaunchUsageError, match="has no argument 'world'; it has world_sdf_file"):
        GzServer(world="empty.sdf")
