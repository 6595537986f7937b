"""Tests of `zbot control` with a controller manager."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import zbot as library
from tests.cli.command import zbot
from tests.nodes.test_control import ARM, URDF, Robot

if TYPE_CHECKING:
    from tests.nodes.conftest import Bench

JSON_PAGE = Path(__file__).parents[2] / "docs/json.md"


@pytest.fixture
def robot(bench: Bench, tmp_path: Path) -> Robot:
    """Return a manager that knows the types of two controllers."""
    robot = Robot(bench, tmp_path, URDF)
    broadcaster = "joint_state_broadcaster/JointStateBroadcaster"
    robot.node.set_parameters([library.Parameter("joints.type", value=broadcaster)])
    (tmp_path / "arm.yaml").write_text(
        "arm:\n  ros__parameters:\n"
        "    type: joint_trajectory_controller/JointTrajectoryController\n"
        + "".join(f"    {name}: {value}\n" for name, value in ARM.items())
    )
    return robot


def states() -> dict[str, str]:
    """Return the states of the controllers that are loaded."""
    listed = json.loads(zbot("control", "list_controllers", "--json").out)
    return {controller["name"]: controller["state"] for controller in listed}


@pytest.mark.usefixtures("robot")
def test_control_loads_and_switches_controllers(tmp_path: Path) -> None:
    # The words are those of the launch files of ROS 2's tutorials.
    loading = zbot("control", "load_controller", "--set-state", "active", "joints")
    assert (loading.code, loading.out) == (
        0,
        "Successfully loaded controller joints into state active\n",
    )
    zbot("control", "load_controller", "arm", str(tmp_path / "arm.yaml"), "--set-state", "inactive")
    assert states() == {"joints": "active", "arm": "inactive"}
    words = ("--deactivate", "joints", "--activate", "arm", "--strict")
    assert zbot("control", "switch_controllers", *words).code == 0
    assert states() == {"joints": "inactive", "arm": "active"}
    refused = zbot("control", "set_controller_state", "arm", "unconfigured")
    assert (refused.code, refused.err) == (1, "arm is active: set it to inactive first\n")
    assert zbot("control", "set_controller_state", "arm", "inactive").code == 0
    assert zbot("control", "set_controller_state", "joints", "start").code == 0
    assert zbot("control", "unload_controller", "arm").code == 0
    assert states() == {"joints": "active"}
    table = zbot("control", "list_controllers", "-c", "controller_manager").out
    assert table == "joints  joint_state_broadcaster/JointStateBroadcaster  active\n"


@pytest.mark.usefixtures("robot")
def test_control_says_why_a_controller_cannot_be_used() -> None:
    failing = zbot("control", "load_controller", "nothing")
    expected = "cannot load nothing: the manager's log has the reason\n"
    assert (failing.code, failing.err) == (1, expected)
    missing = zbot("control", "set_controller_state", "nothing", "active")
    assert missing.err == ("no controller nothing is loaded\n\nhint: loaded are: none\n")
    assert zbot("control", "set_controller_state", "arm", "running").code == 2


@pytest.mark.usefixtures("robot")
def test_control_lists_the_hardware() -> None:
    assert zbot("control", "set_hardware_component_state", "arm", "inactive").code == 0
    listed = zbot("control", "list_hardware_components").out
    assert "name: arm\n\ttype: system\n\tplugin name: mock_components/GenericSystem" in listed
    assert "state: id=2 label=inactive\n\tcommand interfaces\n\t\telbow/position" in listed
    interfaces = zbot("control", "list_hardware_interfaces").out.splitlines()
    assert interfaces[1] == "\tleft/velocity [available] [unclaimed]"
    assert interfaces[4:6] == ["state interfaces", "\tleft/position [available]"]
    types = zbot("control", "list_controller_types").out
    assert "diff_drive_controller/DiffDriveController " in types


def test_the_keys_of_json_are_those_of_the_page(robot: Robot) -> None:
    robot.load("joints", "joint_state_broadcaster/JointStateBroadcaster")
    rows = re.findall(r"^\| `zbot (control .+?)` \| (.+) \|$", JSON_PAGE.read_text(), re.MULTILINE)
    assert len(rows) == 4
    for words, keys in rows:
        printed = json.loads(zbot(*words.split(), "--json").out)
        found = printed[0] if isinstance(printed, list) else printed
        inner = [value[0] for value in found.values() if isinstance(value, list) and value]
        known = {*found, *(key for value in inner if isinstance(value, dict) for key in value)}
        assert {key.strip("`") for key in keys.split()} <= known | {"..."}
