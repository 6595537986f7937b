"""Tests of controllers that command other controllers, and of PIDs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.nodes.test_control import DRIVE, Robot
from zbot_nodes.control.hardware import SimulatedHardware, read_components
from zbot_nodes.control.pid import Pid
from zbot_nodes.control.pid_controller import PidController

from control_msgs.msg import MultiDOFCommand, MultiDOFStateStamped
from controller_manager_msgs import srv
from geometry_msgs.msg import TwistStamped
from std_msgs.msg import Float64MultiArray

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext
    from tests.nodes.conftest import Bench

    from controller_manager_msgs.msg import ControllerState

PASS = "passthrough_controller/PassthroughController"
FORWARD = "forward_command_controller/ForwardCommandController"
PID = "pid_controller/PidController"
LEFT = {
    "dof_names": ["left"],
    "command_interface": "velocity",
    "reference_and_state_interfaces": ["velocity"],
}


@pytest.fixture
def robot(bench: Bench, tmp_path: Path) -> Robot:
    return Robot(bench, tmp_path)


def load_chain(robot: Robot) -> None:
    """Load the controllers `top`, `middle` and `low`, which command each other in this order."""
    robot.load("low", PASS, {"interfaces": ["elbow/position"]})
    robot.load("middle", PASS, {"interfaces": ["low/elbow/position"]})
    robot.load("top", FORWARD, {"joints": ["middle/low/elbow"], "interface_name": "position"})


def listed(robot: Robot) -> dict[str, ControllerState]:
    found = robot.ask("list_controllers", srv.ListControllers).controller
    return {known.name: known for known in found}


def references(robot: Robot) -> dict[str, tuple[bool, bool]]:
    """Return for each reference whether it is available and whether it is claimed."""
    found = robot.ask("list_hardware_interfaces", srv.ListHardwareInterfaces).command_interfaces
    return {
        link.name: (link.is_available, link.is_claimed)
        for link in found
        if link.name.startswith(("low", "middle"))
    }


def test_a_chain_of_controllers_moves_a_joint(robot: Robot) -> None:
    load_chain(robot)
    assert robot.switch(["top", "low", "middle"]).ok
    node: Any = robot.node
    assert [known.get_name() for known in node.controllers.active] == ["top", "middle", "low"]
    robot.bench.publisher(Float64MultiArray, "/top/commands").publish(Float64MultiArray(data=[0.5]))
    assert wait_until(lambda: node.hardware.states["elbow/position"] == 0.5)
    found = listed(robot)
    assert [(known.is_chainable, known.is_chained) for known in found.values()] == [
        (True, True),
        (True, True),
        (False, False),
    ]
    (connection,) = found["top"].chain_connections
    assert connection.name == "middle"
    assert list(connection.reference_interfaces) == ["low/elbow/position"]
    used = (True, True)
    assert references(robot) == {"low/elbow/position": used, "middle/low/elbow/position": used}


def test_a_controller_takes_messages_while_no_other_commands_it(robot: Robot) -> None:
    load_chain(robot)
    assert robot.switch(["low", "middle"]).ok
    free = (False, False)
    assert references(robot)["middle/low/elbow/position"] == free
    publisher = robot.bench.publisher(Float64MultiArray, "/low/commands")
    publisher.publish(Float64MultiArray(data=[0.7]))
    robot.bench.publisher(Float64MultiArray, "/middle/commands").publish(
        Float64MultiArray(data=[0.2])
    )
    states: Any = robot.node.hardware.states  # type: ignore[attr-defined]
    assert wait_until(lambda: states["elbow/position"] == 0.2)
    assert robot.switch([], ["middle"]).ok
    publisher.publish(Float64MultiArray(data=[0.9]))
    assert wait_until(lambda: states["elbow/position"] == 0.9)


def test_a_switch_that_would_break_a_chain_is_refused(robot: Robot) -> None:
    load_chain(robot)
    refused = robot.switch(["middle"])
    assert refused.message == (
        "Controller 'middle' can not be activated: it uses 'low/elbow/position', but 'low' is not "
        "active"
    )
    assert not refused.ok
    assert robot.switch(["low", "middle"]).ok
    refused = robot.switch([], ["low"])
    assert refused.message == (
        "Controller 'low' can not be deactivated: the active controller 'middle' uses "
        "'low/elbow/position'"
    )
    assert not refused.ok
    assert robot.switch([], ["low", "middle"]).ok


def test_a_switch_that_is_not_strict_leaves_out_what_breaks_a_chain(robot: Robot) -> None:
    load_chain(robot)
    robot.load("wheel", "velocity_controllers/JointGroupVelocityController", {"joints": ["left"]})
    answer = robot.ask(
        "switch_controller",
        srv.SwitchController,
        activate_controllers=["top", "middle", "wheel"],
        strictness=srv.SwitchController.Request.BEST_EFFORT,
    )
    active = [known.name for known in listed(robot).values() if known.state == "active"]
    assert (answer.ok, active) == (True, ["wheel"])


def test_two_controllers_of_one_switch_cannot_command_the_same(robot: Robot) -> None:
    for name in ("one", "two"):
        robot.load(name, PASS, {"interfaces": ["elbow/position"]})
    refused = robot.switch(["one", "two"])
    assert "another controller commands 'elbow/position'" in refused.message


def test_the_references_of_an_unloaded_controller_are_gone(robot: Robot) -> None:
    robot.load("low", PASS, {"interfaces": ["elbow/position"]})
    assert list(references(robot)) == ["low/elbow/position"]
    assert robot.ask("unload_controller", srv.UnloadController, name="low").ok
    assert references(robot) == {}


def test_a_differential_drive_commands_the_wheels_by_pids(robot: Robot) -> None:
    for name in ("left", "right"):
        settings: dict[str, Any] = {
            **LEFT,
            "dof_names": [name],
            "gains": {name: {"feedforward_gain": 1.0}},
        }
        robot.load(f"pid_{name}", PID, settings)
    wheels = {"left_wheel_names": ["pid_left/left"], "right_wheel_names": ["pid_right/right"]}
    settings = {**DRIVE, **wheels, "position_feedback": False, "cmd_vel_timeout": 1000.0}
    robot.load("drive", "diff_drive_controller/DiffDriveController", settings)
    assert robot.switch(["drive", "pid_left", "pid_right"]).ok
    states = robot.bench.watch(MultiDOFStateStamped, "/pid_left/controller_state")
    twist = TwistStamped()
    twist.twist.linear.x = 1.0
    robot.bench.publisher(TwistStamped, "/drive/cmd_vel").publish(twist)
    assert wait_until(lambda: bool(states) and states[-1].dof_states[0].feedback == 10.0)
    hardware: Any = robot.node.hardware  # type: ignore[attr-defined]
    assert wait_until(lambda: hardware.states["pid_right/right/velocity"] == 10.0)
    (connection, _) = listed(robot)["drive"].chain_connections
    assert list(connection.reference_interfaces) == ["left/velocity"]


# -- the PID controller ----------------------------------------------------------------------------

WHEEL = """<robot name="r"><link name="base"/><link name="w"/><joint name="left" type="continuous">
<parent link="base"/><child link="w"/></joint><ros2_control name="all" type="system"><hardware>
<plugin>mock_components/GenericSystem</plugin></hardware><joint name="left">
<command_interface name="effort"/><state_interface name="position"/>
<state_interface name="velocity"/></joint></ros2_control></robot>"""


def controller(make_context: MakeContext, **settings: Any) -> PidController:
    hardware = SimulatedHardware(read_components(WHEEL), {})
    values = {**LEFT, "command_interface": "effort", **settings}
    overrides = [zbot.Parameter(name, value=value) for name, value in values.items()]
    node = PidController(
        "pid", hardware, WHEEL, context=make_context(), parameter_overrides=overrides
    )
    node.configure()
    hardware.add(node.reference_interfaces(), node.exported_interfaces())
    node.activate()
    return node


def test_a_pid_with_two_interfaces_uses_the_error_of_the_speed(make_context: MakeContext) -> None:
    node = controller(
        make_context,
        **{
            "reference_and_state_interfaces": ["position", "velocity"],
            "gains.left.p": 2,
            "gains.left.d": 0.5,
            "gains.left.feedforward_gain": 0.1,
        },
    )
    node.hardware.states.update({"left/position": 1.0, "left/velocity": 2.0})
    node.accept(MultiDOFCommand(dof_names=["left"], values=[4.0], values_dot=[3.0]))
    node.update(0.1)
    assert node.hardware.commands["left/effort"] == pytest.approx(2 * 3.0 + 0.5 * 1.0 + 0.1 * 3.0)


def test_angles_of_a_pid_turn_the_short_way(make_context: MakeContext) -> None:
    settings = {"gains.left.p": 1.0, "gains.left.angle_wraparound": True}
    node = controller(make_context, reference_and_state_interfaces=["position"], **settings)
    node.hardware.states["left/position"] = 3.0
    node.accept(MultiDOFCommand(values=[-3.0]))
    node.update(0.1)
    assert node.hardware.commands["left/effort"] == pytest.approx(math.tau - 6.0)


def test_measured_values_come_from_a_topic(make_context: MakeContext) -> None:
    settings = {"gains.left.p": 1.0, "use_external_measured_states": True}
    node = controller(make_context, **settings)
    assert node.state_interfaces() == []
    node.accept(MultiDOFCommand(values=[5.0]))
    node.update(0.1)
    assert math.isnan(node.hardware.commands["left/effort"])
    node.measure(MultiDOFCommand(dof_names=["left"], values=[4.0]))
    node.update(0.1)
    assert node.hardware.commands["left/effort"] == 1.0


def test_the_first_reference_is_the_measured_value(make_context: MakeContext) -> None:
    node = controller(make_context, **{"gains.left.p": 1.0})
    assert node.hardware.commands["pid/left/velocity"] == 0.0
    other = controller(make_context, set_current_state_as_first_setpoint=False)
    assert math.isnan(other.hardware.commands["pid/left/velocity"])


def test_gains_change_while_the_controller_runs(
    make_context: MakeContext, logged: list[Any]
) -> None:
    node = controller(make_context, **{"gains.left.p": 1.0})
    node.accept(MultiDOFCommand(values=[2.0]))
    node.set_parameters([zbot.Parameter("gains.left.p", value=3.0)])
    node.update(0.1)
    assert node.hardware.commands["left/effort"] == 6.0
    node.set_parameters([zbot.Parameter("gains.left.p", value="much")])
    node.update(0.1)
    assert node.hardware.commands["left/effort"] == 6.0
    text = "the parameter gains.left.p of pid must be a number"
    assert any(record.message == text for record in logged)


def test_a_message_with_other_joints_is_refused(
    make_context: MakeContext, logged: list[Any]
) -> None:
    node = controller(make_context, **{"gains.left.p": 1.0})
    node.accept(MultiDOFCommand(dof_names=["arm"], values=[2.0]))
    node.update(0.1)
    assert node.hardware.commands["left/effort"] == 0.0
    assert any(record.message == "a message needs a value for each of left" for record in logged)


@pytest.mark.parametrize(
    ("settings", "reason"),
    [
        ({"command_interface": ""}, "command_interface of pid is empty"),
        ({"reference_and_state_dof_names": ["a", "b"]}, "must have equally many names"),
        ({"reference_and_state_interfaces": ["a", "b", "c"]}, "has more than two names"),
        ({"gains.left.antiwindup_strategy": "clamp"}, "is 'clamp': write one of none, cond"),
    ],
)
def test_wrong_parameters_of_a_pid_are_named(
    make_context: MakeContext, settings: dict[str, Any], reason: str
) -> None:
    with pytest.raises(zbot.ZbotError, match=reason):
        controller(make_context, **settings)


# -- PIDs ----------------------------------------------------------------------------------------


def test_the_integral_part_grows_up_to_its_limit() -> None:
    pid = Pid(i=2.0, i_clamp_max=0.5)
    assert [pid.command(1.0, 0.1) for _ in range(4)] == pytest.approx([0.2, 0.4, 0.5, 0.5])


def test_the_derivative_part_is_the_change_of_the_error() -> None:
    pid = Pid(d=0.5)
    assert [pid.command(error, 0.1) for error in (1.0, 2.0)] == pytest.approx([0.0, 5.0])
    pid.reset()
    assert pid.command(4.0, 0.1) == 0.0


def test_errors_in_the_deadband_do_not_change_the_integral_part() -> None:
    pid = Pid(i=1.0, error_deadband=0.5)
    assert (pid.command(0.5, 1.0), pid.command(0.6, 1.0)) == (0.0, 0.6)


@pytest.mark.parametrize(
    ("strategy", "expected"),
    [("none", 9.0), ("conditional_integration", 0.0), ("back_calculation", 1.0)],
)
def test_a_limited_command_changes_the_integral_part_as_the_strategy_says(
    strategy: str, expected: float
) -> None:
    pid = Pid(p=1.0, i=1.0, u_clamp_max=1.0, antiwindup_strategy=strategy)
    assert pid.command(9.0, 1.0) == 1.0
    assert pid.integral == pytest.approx(expected)
