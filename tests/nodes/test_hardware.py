"""Tests of the states of hardware components: what moves, and what controllers may use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from tests.conftest import wait_until
from tests.nodes.test_control import URDF, Robot

from controller_manager_msgs import srv
from lifecycle_msgs.msg import State as LifecycleState
from sensor_msgs.msg import JointState

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import Start
    from tests.nodes.conftest import Bench


@pytest.fixture
def robot(bench: Bench, tmp_path: Path) -> Robot:
    return Robot(bench, tmp_path)


def test_the_broadcaster_publishes_the_joints_of_configured_hardware(robot: Robot) -> None:
    states = robot.bench.watch(JointState, "/joint_states")
    hardware: Any = robot.node.hardware  # type: ignore[attr-defined]
    hardware.set_component_state("drive", "unconfigured")
    robot.load("joints", "joint_state_broadcaster/JointStateBroadcaster")
    assert robot.switch(["joints"]).ok
    assert wait_until(lambda: bool(states))
    assert states[-1].name == ["elbow"]
    hardware.set_component_state("drive", "inactive")
    assert robot.switch([], ["joints"]).ok
    assert robot.switch(["joints"]).ok
    assert wait_until(lambda: states[-1].name == ["left", "right", "elbow"])


def test_the_broadcaster_needs_some_configured_hardware(robot: Robot) -> None:
    hardware: Any = robot.node.hardware  # type: ignore[attr-defined]
    for name in ("drive", "arm"):
        hardware.set_component_state(name, "unconfigured")
    robot.load("joints", "joint_state_broadcaster/JointStateBroadcaster")
    refused = robot.switch(["joints"])
    assert not refused.ok
    assert "the hardware 'arm' is not configured" in refused.message


def test_hardware_moves_when_a_hardware_spawner_activates_it(start: Start, tmp_path: Path) -> None:
    (tmp_path / "robot.yaml").write_text(
        "/**:\n  ros__parameters:\n    robot_description: |\n"
        + "".join(f"      {line}\n" for line in URDF.splitlines())
        + "    hardware_components_initial_state:\n      unconfigured: [arm]\n"
        + "    arm_joint:\n      type: position_controllers/JointGroupPositionController\n"
        + "    joints: [elbow]\n"
    )
    run = ("zbot", "run", "controller_manager")
    manager = start(*run, "ros2_control_node", "--ros-args", "--params-file", "robot.yaml")
    manager.wait_for("The hardware 'arm' is unconfigured", 20)
    early = start(*run, "spawner", "arm_joint")
    early.wait_for("interface 'elbow/position', but the hardware 'arm' is not configured", 20)
    assert early.wait() == 1
    spawner = start(*run, "hardware_spawner", "arm", "--activate")
    spawner.wait_for("Hardware component 'arm' is active", 20)
    assert spawner.wait() == 0
    assert start(*run, "spawner", "arm_joint").wait(20) == 0
    failing = start(*run, "hardware_spawner", "leg", "--configure")
    failing.wait_for("error: the hardware component 'leg' did not become inactive", 20)
    assert failing.wait() == 1
    manager.wait_for("There is no hardware component 'leg': there are drive, arm", 20)


def test_inactive_hardware_does_not_move(robot: Robot) -> None:
    robot.start("wheels", "velocity_controllers/JointGroupVelocityController", {"joints": ["left"]})
    hardware: Any = robot.node.hardware  # type: ignore[attr-defined]

    def become(state: str, name: str = "drive") -> Any:
        target = LifecycleState(label=state)
        kind = srv.SetHardwareComponentState
        return robot.ask("set_hardware_component_state", kind, name=name, target_state=target)

    assert become("inactive").state.id == LifecycleState.PRIMARY_STATE_INACTIVE
    hardware.commands["left/velocity"] = 2.0
    hardware.read(0.1)
    assert hardware.states["left/position"] == 0.0
    assert become("active").ok
    hardware.read(0.1)
    assert hardware.states["left/position"] == 0.0  # it waits for a new command
    hardware.commands["left/velocity"] = 2.0
    hardware.read(0.1)
    assert hardware.states["left/position"] > 0
    assert become("unconfigured").ok
    listed = robot.ask("list_hardware_interfaces", srv.ListHardwareInterfaces)
    available = {interface.name: interface.is_available for interface in listed.state_interfaces}
    assert (available["left/position"], available["elbow/position"]) == (False, True)
    assert not become("asleep").ok
    assert not become("active", "leg").ok
    assert become("finalized").ok
    assert not become("active").ok
