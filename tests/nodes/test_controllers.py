"""Tests of grippers, steered wheels and sensors on a simulated hardware."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.nodes.test_control import Robot
from zbot.action import ActionClient
from zbot_nodes.control.hardware import SimulatedHardware, read_components
from zbot_nodes.control.steering_controllers import (
    AckermannSteeringController,
    BicycleSteeringController,
    SteeringController,
    TricycleSteeringController,
)

from action_msgs.msg import GoalStatus
from control_msgs.action import GripperCommand, ParallelGripperCommand
from control_msgs.msg import (
    DynamicInterfaceGroupValues,
    InterfaceValue,
    SteeringControllerStatus,
)
from controller_manager_msgs import srv
from geometry_msgs.msg import TwistStamped, WrenchStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import Imu, JointState, Range
from std_msgs.msg import Float64MultiArray

if TYPE_CHECKING:
    from pathlib import Path

    from tests.conftest import MakeContext
    from tests.nodes.conftest import Bench

FINGER = (
    '<command_interface name="position"/><command_interface name="max_effort"/>'
    '<state_interface name="position"/><state_interface name="velocity"/>'
    '<state_interface name="max_effort"/>'
)
WHEEL = '<command_interface name="velocity"/><state_interface name="velocity"/>'
STEERED = '<command_interface name="position"/><state_interface name="position"/>'


def sensor(name: str, values: dict[str, float]) -> str:
    interfaces = "".join(
        f'<state_interface name="{key}"><param name="initial_value">{value}</param>'
        "</state_interface>"
        for key, value in values.items()
    )
    return f'<sensor name="{name}">{interfaces}</sensor>'


IMU = {f"orientation.{axis}": 0.0 for axis in "xyz"} | {"orientation.w": 1.0}
IMU |= {f"angular_velocity.{axis}": 0.5 for axis in "xyz"}
IMU |= {f"linear_acceleration.{axis}": 9.81 for axis in "xyz"}
FORCES = {f"{part}.{axis}": 2.0 for part in ("force", "torque") for axis in "xyz"}
NAMES = ("finger", "right", "left", "right_steer", "left_steer")
JOINTS = "".join(
    f'<link name="{name}"/><joint name="{name}" type="continuous"><parent link="base"/>'
    f'<child link="{name}"/></joint>'
    for name in NAMES
)
PARTS = "".join(
    f'<joint name="{name}">{part}</joint>'
    for name, part in zip(NAMES, (FINGER, WHEEL, WHEEL, STEERED, STEERED), strict=True)
)
SENSORS = sensor("imu", IMU) + sensor("wrist", FORCES) + sensor("bumper", {"range": 1.5})
LAMP = (
    '<gpio name="lamp"><command_interface name="on"/><state_interface name="on"/>'
    '<state_interface name="heat"/></gpio>'
)
CAR = f"""<robot name="car"><link name="base"/>{JOINTS}<ros2_control name="all" type="system">
<hardware><plugin>mock_components/GenericSystem</plugin></hardware>{PARTS}{SENSORS}
{LAMP}</ros2_control></robot>"""
WHEELBASE, TRACK = 2.0, 1.0


@pytest.fixture
def car(bench: Bench, tmp_path: Path) -> Robot:
    return Robot(bench, tmp_path, CAR)


# -- grippers ------------------------------------------------------------------------------------


def send(car: Robot, kind: Any, goal: Any) -> tuple[int, Any]:
    """Send a goal to the gripper, and return its final state and the result."""
    client: Any = ActionClient(car.bench.watcher, kind, "/grip/gripper_cmd")
    assert client.wait_for_server(10)
    accepted = client.send_goal_async(goal)
    assert wait_until(accepted.done)
    handle: Any = accepted.result()
    if not handle.accepted:
        return GoalStatus.STATUS_UNKNOWN, None
    result = handle.get_result_async()
    assert wait_until(result.done)
    return result.result().status, result.result().result


def test_a_gripper_moves_to_a_position(car: Robot) -> None:
    car.start("grip", "position_controllers/GripperActionController", {"joint": "finger"})
    goal = GripperCommand.Goal()
    goal.command.position = 0.04
    status, result = send(car, GripperCommand, goal)
    assert status == GoalStatus.STATUS_SUCCEEDED
    assert (result.reached_goal, result.stalled, result.position) == (True, False, 0.04)


@pytest.mark.parametrize("may_stall", [False, True])
def test_a_gripper_that_does_not_move_is_stalled(
    bench: Bench, tmp_path: Path, may_stall: bool
) -> None:
    stuck = CAR.replace("</plugin>", '</plugin><param name="disable_commands">true</param>')
    car = Robot(bench, tmp_path, stuck)
    settings = {"joint": "finger", "stall_timeout": 0.05, "allow_stalling": may_stall}
    car.start("grip", "position_controllers/GripperActionController", settings)
    goal = GripperCommand.Goal()
    goal.command.position = 0.04
    status, result = send(car, GripperCommand, goal)
    ends = {False: GoalStatus.STATUS_ABORTED, True: GoalStatus.STATUS_SUCCEEDED}
    assert (status, result.stalled, result.reached_goal) == (ends[may_stall], True, False)


def test_a_parallel_gripper_limits_the_effort(car: Robot) -> None:
    settings = {"joint": "finger", "max_effort_interface": "finger/max_effort", "max_effort": 7.0}
    car.start("grip", "parallel_gripper_action_controller/GripperActionController", settings)
    command = JointState(position=[0.02])
    goal = ParallelGripperCommand.Goal(command=command)
    status, result = send(car, ParallelGripperCommand, goal)
    assert (status, list(result.state.position)) == (GoalStatus.STATUS_SUCCEEDED, [0.02])
    hardware: Any = car.node.hardware  # type: ignore[attr-defined]
    assert hardware.commands["finger/max_effort"] == 7.0
    wrong = ParallelGripperCommand.Goal(command=JointState(position=[0.1, 0.2]))
    assert send(car, ParallelGripperCommand, wrong)[1] is None


# -- wheels that steer -----------------------------------------------------------------------------

GEOMETRY = {
    "wheelbase": WHEELBASE,
    "traction_wheels_radius": 0.5,
    "traction_wheel_radius": 0.5,
    "traction_track_width": TRACK,
    "reference_timeout": 1000.0,  # tests run on busy machines
}
DRIVEN, STEERED_NAMES = ["right", "left"], ["right_steer", "left_steer"]


def steering(
    make_context: MakeContext, kind: type[SteeringController], **settings: Any
) -> SteeringController:
    """Return a configured controller that its hardware follows immediately."""
    hardware = SimulatedHardware(read_components(CAR), {})
    joints = {
        "traction_joints_names": DRIVEN[: kind.counts[0]],
        "steering_joints_names": STEERED_NAMES[: kind.counts[1]],
    }
    values = {**GEOMETRY, **joints, **settings}
    overrides = [
        zbot.Parameter(name, value=value) for name, value in values.items() if value is not None
    ]
    controller = kind("drive", hardware, CAR, context=make_context(), parameter_overrides=overrides)
    controller.configure()
    controller.activate()
    return controller


def drive(controller: SteeringController, linear: float, angular: float, periods: int = 1) -> None:
    controller.command = linear, angular
    controller.received_ns = controller.get_clock().now().nanoseconds
    for _ in range(periods):
        controller.hardware.read(0.1)
        controller.update(0.1)


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        (BicycleSteeringController, {"right": 2.0, "right_steer": math.atan(0.5)}),
        (
            TricycleSteeringController,
            {"right": 2.25, "left": 1.75, "right_steer": math.atan(0.5)},
        ),
        (
            AckermannSteeringController,
            {
                "right": 2.25,
                "left": 1.75,
                "right_steer": math.atan(2.0 / 4.5),
                "left_steer": math.atan(2.0 / 3.5),
            },
        ),
    ],
)
def test_wheels_drive_a_curve_of_four_metres(
    make_context: MakeContext, kind: type[SteeringController], expected: dict[str, float]
) -> None:
    controller = steering(make_context, kind)
    drive(controller, 1.0, 0.25, periods=2)  # in the first period, the wheels do not steer yet
    found = {
        name.partition("/")[0]: command for name, command in controller.hardware.commands.items()
    }
    assert {name: found[name] for name in expected} == pytest.approx(expected)


@pytest.mark.parametrize(
    "kind",
    [AckermannSteeringController, BicycleSteeringController, TricycleSteeringController],
)
@pytest.mark.parametrize("is_open_loop", [True, False])
def test_odometry_is_the_way_of_the_robot(
    make_context: MakeContext, kind: type[SteeringController], is_open_loop: bool
) -> None:
    controller = steering(make_context, kind, open_loop=is_open_loop)
    drive(controller, 1.0, 0.25, periods=1 if is_open_loop else 3)
    controller.reset_odometry()
    drive(controller, 1.0, 0.25, periods=10)
    assert controller.heading == pytest.approx(0.25)
    assert controller.x == pytest.approx(4.0 * math.sin(0.25))
    assert controller.y == pytest.approx(4.0 * (1 - math.cos(0.25)))


def test_a_robot_that_stands_does_not_turn_on_the_spot(make_context: MakeContext) -> None:
    controller = steering(make_context, BicycleSteeringController, open_loop=True)
    drive(controller, 0.0, 1.0)
    commands = controller.hardware.commands
    assert (commands["right_steer/position"], commands["right/velocity"]) == (math.pi / 2, 0.0)


def test_wheels_are_slow_until_they_are_steered(make_context: MakeContext) -> None:
    controller = steering(
        make_context, BicycleSteeringController, reduce_wheel_speed_until_steering_reached=True
    )
    drive(controller, 1.0, 2.0)
    assert 0 < controller.hardware.commands["right/velocity"] < 1.0
    drive(controller, 1.0, 2.0)
    assert controller.hardware.commands["right/velocity"] == 2.0


@pytest.mark.parametrize(
    ("settings", "reason"),
    [
        ({"traction_joints_names": ["right"]}, "traction_joints_names of drive must have 2 joints"),
        ({"wheelbase": 0.0}, "wheelbase of drive must be above 0"),
        ({"traction_wheels_radius": 0.0}, "traction_wheels_radius of drive must be above 0"),
    ],
)
def test_wrong_wheels_are_named(
    make_context: MakeContext, settings: dict[str, Any], reason: str
) -> None:
    with pytest.raises(zbot.ZbotError, match=reason):
        steering(make_context, AckermannSteeringController, **settings)


def test_parameters_of_jazzy_are_read(make_context: MakeContext) -> None:
    controller = steering(
        make_context,
        AckermannSteeringController,
        traction_joints_names=None,
        steering_joints_names=None,
        rear_wheels_names=DRIVEN,
        front_wheels_names=STEERED_NAMES,
        traction_wheels_radius=0.0,
        rear_wheels_radius=0.25,
        traction_track_width=0.0,
        rear_wheel_track=0.8,
        front_wheel_track=0.6,
    )
    assert (controller.driven, controller.steered) == (DRIVEN, STEERED_NAMES)
    found = controller.radius, controller.track, controller.steering_track
    assert found == (0.25, 0.8, 0.6)


def test_a_car_drives_and_publishes(car: Robot, logged: list[Any]) -> None:
    odometry = car.bench.watch(Odometry, "/drive/odometry")
    states = car.bench.watch(SteeringControllerStatus, "/drive/controller_state")
    names = {"traction_joints_names": DRIVEN, "steering_joints_names": STEERED_NAMES}
    settings = {**GEOMETRY, **names, "wheel_colour": "red"}
    kind = "ackermann_steering_controller/AckermannSteeringController"
    car.start("drive", kind, settings)
    publisher = car.bench.publisher(TwistStamped, "/drive/reference")
    twist = TwistStamped()
    twist.twist.linear.x = 1.0
    publisher.publish(twist)
    assert wait_until(lambda: bool(odometry) and odometry[-1].pose.pose.position.x > 0.05)
    assert wait_until(lambda: list(states[-1].traction_wheels_velocity) == [2.0, 2.0])
    unknown = [
        record.message for record in logged if "does not use the parameters" in record.message
    ]
    assert unknown == [
        "Controller 'drive' does not use the parameters traction_wheel_radius, unused, wheel_colour"
    ]


# -- sensors ---------------------------------------------------------------------------------------


def test_sensors_are_published(car: Robot) -> None:
    imu = car.bench.watch(Imu, "/imu/imu")
    wrench = car.bench.watch(WrenchStamped, "/wrist/wrench")
    ranges = car.bench.watch(Range, "/bumper/range")
    frame = {"frame_id": "head"}
    car.start("imu", "imu_sensor_broadcaster/IMUSensorBroadcaster", {"sensor_name": "imu", **frame})
    names = {"interface_names": {"force": {"z": "wrist/force.z"}}, "offset": {"force": {"z": 1.0}}}
    kind = "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster"
    car.start("wrist", kind, {**names, "multiplier": {"force": {"z": 2.0}}, **frame})
    settings = {"sensor_name": "bumper", "max_range": 3, **frame}
    car.start("bumper", "range_sensor_broadcaster/RangeSensorBroadcaster", settings)
    assert wait_until(lambda: all((imu, wrench, ranges)))
    assert (imu[0].header.frame_id, imu[0].orientation.w) == ("head", 1.0)
    assert (imu[0].angular_velocity.y, imu[0].linear_acceleration.z) == (0.5, 9.81)
    assert wrench[0].wrench.force.z == 6.0
    assert math.isnan(wrench[0].wrench.torque.x)
    assert (ranges[0].range, ranges[0].max_range) == (1.5, 3.0)


def test_a_sensor_without_a_frame_is_refused(car: Robot, logged: list[Any]) -> None:
    with pytest.raises(AssertionError):
        car.load("imu", "imu_sensor_broadcaster/IMUSensorBroadcaster", {"sensor_name": "imu"})
    assert any(record.message == "the parameter frame_id of imu is empty" for record in logged)


# -- several interfaces of a joint -----------------------------------------------------------------


def test_values_go_to_several_interfaces_of_a_joint(car: Robot) -> None:
    settings = {"joint": "finger", "interface_names": ["position", "max_effort"]}
    kind = "forward_command_controller/MultiInterfaceForwardCommandController"
    car.start("both", kind, settings)
    publisher = car.bench.publisher(Float64MultiArray, "/both/commands")
    publisher.publish(Float64MultiArray(data=[0.03, 5.0]))
    hardware: Any = car.node.hardware  # type: ignore[attr-defined]
    assert wait_until(lambda: hardware.states["finger/max_effort"] == 5.0)
    assert hardware.states["finger/position"] == 0.03
    listed = car.ask("list_hardware_interfaces", srv.ListHardwareInterfaces).command_interfaces
    assert {interface.name for interface in listed if interface.is_claimed} == {
        "finger/position",
        "finger/max_effort",
    }


# -- inputs and outputs ----------------------------------------------------------------------------


def test_outputs_are_commanded_and_published(car: Robot, logged: list[Any]) -> None:
    states = car.bench.watch(DynamicInterfaceGroupValues, "/pins/gpio_states")
    settings = {"gpios": ["lamp"], "command_interfaces": {"lamp": {"interfaces": ["on"]}}}
    car.start("pins", "gpio_controllers/GpioCommandController", settings)
    publisher = car.bench.publisher(DynamicInterfaceGroupValues, "/pins/commands")
    values = InterfaceValue(interface_names=["on", "colour"], values=[1.0, 2.0])
    command = DynamicInterfaceGroupValues(interface_groups=["lamp"], interface_values=[values])
    publisher.publish(command)

    def found() -> dict[str, float]:
        (group,) = states[-1].interface_values
        return dict(zip(group.interface_names, group.values, strict=True))

    assert wait_until(lambda: bool(states) and found() == {"on": 1.0, "heat": 0.0})
    text = "there is no command interface 'lamp/colour'"
    assert wait_until(lambda: any(record.message == text for record in logged))
