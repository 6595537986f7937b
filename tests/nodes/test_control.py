"""Tests of the controller manager and its controllers."""

from __future__ import annotations

import math
from functools import partial
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from zbot.action import ActionClient, ActionServer
from zbot.qos import DurabilityPolicy, QoSProfile
from zbot_nodes.control.controller import Controller
from zbot_nodes.control.controller_manager import ControllerManager
from zbot_nodes.control.controller_types import TYPES

from control_msgs.action import FollowJointTrajectory, GripperCommand
from control_msgs.msg import DynamicJointState, JointTrajectoryControllerState
from control_msgs.srv import QueryTrajectoryState, SetOdometry
from controller_manager_msgs import srv
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray, String
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
from visualization_msgs.msg import MarkerArray

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.nodes.conftest import Bench

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
STATES = '<state_interface name="position"/><state_interface name="velocity"/>'
JOINTS = "".join(
    f'<link name="{name}"/><joint name="{name}" type="continuous"><parent link="base"/>'
    f'<child link="{name}"/></joint>'
    for name in ("left", "right", "elbow")
)
URDF = f"""<robot name="r"><link name="base"/>{JOINTS}
<ros2_control name="drive" type="system"><hardware><plugin>my_robot/Motors</plugin></hardware>
<joint name="left"><command_interface name="velocity"/>{STATES}</joint>
<joint name="right"><command_interface name="velocity"/>{STATES}</joint></ros2_control>
<ros2_control name="arm" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>
</hardware><joint name="elbow"><command_interface name="position"/>{STATES}</joint></ros2_control>
</robot>"""
DRIVE = {
    "left_wheel_names": ["left"],
    "right_wheel_names": ["right"],
    "wheel_separation": 0.5,
    "wheel_radius": 0.1,
}
ARM: dict[str, Any] = {
    "joints": ["elbow"],
    "command_interfaces": ["position"],
    "state_interfaces": ["position", "velocity"],
}
MANAGER = "/controller_manager"


class Robot:
    """Controller manager under test."""

    def __init__(self, bench: Bench, tmp_path: Path, description: str = URDF) -> None:
        self.bench, self.folder = bench, tmp_path
        settings = {"robot_description": description, "update_rate": 50}
        self.node = bench.run(ControllerManager, settings)

    def ask(self, service: str, type_: Any, **fields: Any) -> Any:
        return self.bench.call(type_, f"{MANAGER}/{service}", type_.Request(**fields))

    def load(self, name: str, kind: str, settings: dict[str, Any] | None = None) -> None:
        """Load and configure a controller."""
        path = self.folder / f"{name}.yaml"
        lines = "".join(f"    {key}: {value}\n" for key, value in (settings or {}).items())
        path.write_text(f"{name}:\n  ros__parameters:\n    unused: 0\n{lines}")
        self.node.set_parameters(
            [
                zbot.Parameter(f"{name}.type", value=kind),
                zbot.Parameter(f"{name}.params_file", value=str(path)),
            ]
        )
        assert self.ask("load_controller", srv.LoadController, name=name).ok
        assert self.ask("configure_controller", srv.ConfigureController, name=name).ok

    def switch(self, begin: list[str], end: list[str] | None = None) -> Any:
        return self.ask(
            "switch_controller",
            srv.SwitchController,
            activate_controllers=begin,
            deactivate_controllers=end or [],
            strictness=srv.SwitchController.Request.STRICT,
        )

    def start(self, name: str, kind: str, settings: dict[str, Any] | None = None) -> None:
        self.load(name, kind, settings)
        assert self.switch([name]).ok


@pytest.fixture
def robot(bench: Bench, tmp_path: Path) -> Robot:
    return Robot(bench, tmp_path)


# -- the manager ---------------------------------------------------------------------------------


def test_the_description_comes_from_the_topic(bench: Bench) -> None:
    node = bench.run(ControllerManager)
    assert node.get_parameter("update_rate").value == 100
    publisher = bench.publisher(String, "/robot_description", KEPT)
    publisher.publish(String(data="<robot/>"))
    publisher.publish(String(data=URDF))
    request = srv.ListHardwareComponents.Request()
    found = bench.call(srv.ListHardwareComponents, f"{MANAGER}/list_hardware_components", request)
    assert [component.name for component in found.component] == ["drive", "arm"]
    assert found.component[0].plugin_name == "my_robot/Motors"
    assert found.component[0].state.label == "active"


def test_a_compiled_driver_is_named_and_simulated(bench: Bench, logged: list[Any]) -> None:
    bench.run(ControllerManager, {"robot_description": URDF})
    text = "\n".join(record.message for record in logged)
    assert "my_robot/Motors is a compiled driver, which does not run here: the hardware" in text
    assert "mock_components" not in text


def test_a_manager_beside_a_simulator_says_that_it_moves_no_bodies(
    bench: Bench, logged: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot_nodes.control.controller_manager._LOOK_S", 0.05)
    bench.run(ControllerManager, {"robot_description": URDF})
    bench.watcher.create_publisher(MarkerArray, "/simulation/world", KEPT)
    told = "A simulator runs in this domain, but this manager moves no bodies in it"
    assert wait_until(lambda: any(told in record.message for record in logged))


def test_controllers_have_states_and_claim_interfaces(robot: Robot) -> None:
    robot.load("wheels", "velocity_controllers/JointGroupVelocityController", {"joints": ["left"]})
    robot.load("others", "velocity_controllers/JointGroupVelocityController", {"joints": ["left"]})

    def states() -> dict[str, str]:
        found = robot.ask("list_controllers", srv.ListControllers).controller
        return {controller.name: controller.state for controller in found}

    assert states() == {"wheels": "inactive", "others": "inactive"}
    assert robot.switch(["wheels"]).ok
    assert states()["wheels"] == "active"
    listed = robot.ask("list_hardware_interfaces", srv.ListHardwareInterfaces)
    claimed = {interface.name: interface.is_claimed for interface in listed.command_interfaces}
    assert claimed == {"left/velocity": True, "right/velocity": False, "elbow/position": False}
    refused = robot.switch(["others"])
    assert (refused.ok, "another controller commands 'left/velocity'" in refused.message) == (
        False,
        True,
    )
    assert robot.switch(["others"], ["wheels"]).ok
    assert states() == {"wheels": "inactive", "others": "active"}
    assert not robot.ask("unload_controller", srv.UnloadController, name="others").ok
    assert robot.ask("unload_controller", srv.UnloadController, name="wheels").ok
    assert list(states()) == ["others"]
    types = robot.ask("list_controller_types", srv.ListControllerTypes).types
    assert "diff_drive_controller/DiffDriveController" in types


@pytest.mark.parametrize(
    ("kind", "settings", "reason"),
    [
        ("", {}, "The 'type' param was not defined for 'one'"),
        ("my/Own", {}, "There is no controller type 'my/Own': there are ackermann"),
        (
            "diff_drive_controller/DiffDriveController",
            {**DRIVE, "wheel_radius": 0},
            "the parameter wheel_radius of one must be above 0",
        ),
        (
            "diff_drive_controller/DiffDriveController",
            {**DRIVE, "left_wheel_names": ["left", "left2"]},
            "one has 2 left and 1 right wheels",
        ),
        (
            "joint_trajectory_controller/JointTrajectoryController",
            {**ARM, "command_interfaces": ["speed"]},
            "must name position, velocity, acceleration or effort",
        ),
        (
            "joint_trajectory_controller/JointTrajectoryController",
            {**ARM, "joints": "elbow"},
            "the parameter joints of one must be a list",
        ),
        (
            "forward_command_controller/ForwardCommandController",
            {},
            "interface_name of one is empty",
        ),
        (
            "position_controllers/JointGroupPositionController",
            {"joints": ["left"]},
            "needs the interface 'left/position', which neither the hardware nor another",
        ),
    ],
)
def test_mistakes_are_named_in_the_log(
    robot: Robot, logged: list[Any], kind: str, settings: dict[str, Any], reason: str
) -> None:
    with pytest.raises(AssertionError):
        robot.start("one", kind, settings)
    assert any(reason in record.message for record in logged), [record.message for record in logged]


def test_a_controller_that_fails_halfway_leaves_nothing_behind(
    robot: Robot, monkeypatch: pytest.MonkeyPatch, logged: list[Any]
) -> None:
    class Half(Controller):
        def configure(self) -> None:
            self.create_subscription(String, "~/half", lambda _: None, 1)
            raise TypeError("a defect")

    monkeypatch.setitem(TYPES, "my/Half", Half)
    with pytest.raises(AssertionError):
        robot.load("one", "my/Half")
    assert any(record.message == "TypeError('a defect')" for record in logged)
    assert wait_until(lambda: robot.bench.watcher.count_subscribers("/one/half") == 0)
    (found,) = robot.ask("list_controllers", srv.ListControllers).controller
    assert (found.name, found.state) == ("one", "unconfigured")


# -- controllers ---------------------------------------------------------------------------------


def test_the_broadcaster_publishes_all_joints(robot: Robot) -> None:
    states = robot.bench.watch(JointState, "/joint_states")
    dynamic = robot.bench.watch(DynamicJointState, "/dynamic_joint_states")
    kind = "joint_state_broadcaster/JointStateBroadcaster"
    robot.start("joint_state_broadcaster", kind, {"extra_joints": ["gripper"]})
    assert wait_until(lambda: bool(states) and bool(dynamic))
    assert states[-1].name == ["left", "right", "elbow", "gripper"]
    assert list(states[-1].position) == [0, 0, 0, 0]
    assert math.isnan(states[-1].effort[0])
    assert states[-1].header.frame_id == "base_link"
    assert dynamic[-1].joint_names == ["left", "right", "elbow"]
    assert dynamic[-1].interface_values[0].interface_names == ["position", "velocity"]


def test_a_robot_drives_an_arc_and_stops_without_commands(robot: Robot) -> None:
    odometry = robot.bench.watch(Odometry, "/base/odom")
    frames = robot.bench.watch(TFMessage, "/tf")
    settings = {**DRIVE, "cmd_vel_timeout": 0.3, "pose_covariance_diagonal": [1.0] * 6}
    robot.start("base", "diff_drive_controller/DiffDriveController", settings)
    publisher = robot.bench.publisher(TwistStamped, "/base/cmd_vel")
    command = TwistStamped()
    command.twist.linear.x, command.twist.angular.z = 0.5, 1.0

    def drive() -> bool:
        publisher.publish(command)  # without a time stamp: it is new
        return bool(odometry) and odometry[-1].pose.pose.position.x > 0.2

    assert wait_until(drive)
    moving = max(odometry, key=lambda message: message.twist.twist.linear.x).twist.twist
    assert moving.linear.x == pytest.approx(0.5, rel=0.1)
    assert wait_until(lambda: bool(odometry) and odometry[-1].twist.twist.linear.x == 0)
    pose = odometry[-1].pose.pose
    heading = 2 * math.atan2(pose.orientation.z, pose.orientation.w)
    # The way is an arc with a radius of 0.5 m.
    assert pose.position.x == pytest.approx(0.5 * math.sin(heading), abs=1e-3)
    assert pose.position.y == pytest.approx(0.5 * (1 - math.cos(heading)), abs=1e-3)
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("odom", "base_link")
    assert odometry[-1].pose.covariance[0] == odometry[-1].pose.covariance[35] == 1.0
    assert wait_until(
        lambda: frames[-1].transforms[0].transform.rotation == odometry[-1].pose.pose.orientation
    )
    answer = robot.bench.call(
        SetOdometry, "/base/set_odometry", SetOdometry.Request(x=3.0, yaw=1.0)
    )
    assert answer.success
    assert wait_until(lambda: bool(odometry) and odometry[-1].pose.pose.position.x == 3.0)


def test_a_robot_stops_without_commands_if_the_clock_of_the_sender_is_ahead(robot: Robot) -> None:
    odometry = robot.bench.watch(Odometry, "/base/odom")
    settings = {**DRIVE, "cmd_vel_timeout": 0.3}
    robot.start("base", "diff_drive_controller/DiffDriveController", settings)
    publisher = robot.bench.publisher(TwistStamped, "/base/cmd_vel")
    command = TwistStamped()
    later = robot.bench.watcher.get_clock().now() + zbot.Duration(seconds=3600)
    command.header.stamp = later.to_msg()
    command.twist.linear.x = 0.5

    def drive() -> bool:
        publisher.publish(command)
        return any(message.twist.twist.linear.x > 0 for message in odometry)

    assert wait_until(drive)
    assert wait_until(lambda: bool(odometry) and odometry[-1].twist.twist.linear.x == 0)


def test_the_wheels_turn_as_kinematics_demand(robot: Robot) -> None:
    settings = {**DRIVE, "use_stamped_vel": False, "cmd_vel_timeout": 0, "open_loop": True}
    limits = {"linear.x.max_velocity": 0.2, "publish_limited_velocity": True}
    limited = robot.bench.watch(TwistStamped, "/base/cmd_vel_out")
    odometry = robot.bench.watch(Odometry, "/base/odom")
    settings |= {"odom_frame_id": "map", "tf_frame_prefix": "/r1"}
    robot.start("base", "diff_drive_controller/DiffDriveController", {**settings, **limits})
    states = robot.bench.watch(JointState, "/joint_states")
    robot.start("joint_states", "joint_state_broadcaster/JointStateBroadcaster")
    command = Twist()
    command.linear.x, command.angular.z = 1.0, 0.4
    robot.bench.publisher(Twist, "/base/cmd_vel_unstamped").publish(command)
    # Left: (0.2 - 0.4 * 0.25) / 0.1 rad/s; right: (0.2 + 0.4 * 0.25) / 0.1 rad/s.
    assert wait_until(
        lambda: bool(states) and list(states[-1].velocity[:2]) == pytest.approx([1, 3])
    )
    assert wait_until(lambda: bool(limited) and limited[-1].twist.linear.x == 0.2)
    assert wait_until(lambda: bool(odometry))
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("r1/map", "r1/base_link")
    assert robot.switch([], ["base"]).ok
    assert wait_until(lambda: list(states[-1].velocity[:2]) == [0, 0])


def goal_for(position: float, seconds: int, **more: Any) -> FollowJointTrajectory.Goal:
    goal = FollowJointTrajectory.Goal(**more)
    goal.trajectory = trajectory(position, seconds)
    return goal


def trajectory(position: float, seconds: int) -> JointTrajectory:
    point = JointTrajectoryPoint(positions=[position])
    point.time_from_start.sec = seconds
    return JointTrajectory(joint_names=["elbow"], points=[point])


def test_an_arm_follows_a_goal(robot: Robot) -> None:
    states = robot.bench.watch(JointTrajectoryControllerState, "/arm/controller_state")
    robot.start("arm", "joint_trajectory_controller/JointTrajectoryController", ARM)
    client: Any = ActionClient(
        robot.bench.watcher, FollowJointTrajectory, "/arm/follow_joint_trajectory"
    )
    assert client.wait_for_server(10)
    feedback: list[Any] = []
    accepted = client.send_goal_async(
        goal_for(0.5, 1), lambda message: feedback.append(message.feedback)
    )
    assert wait_until(accepted.done)
    result = accepted.result().get_result_async()
    assert wait_until(result.done, 10)
    assert result.result().result.error_code == FollowJointTrajectory.Result.SUCCESSFUL
    assert wait_until(
        lambda: bool(states) and states[-1].feedback.positions[0] == pytest.approx(0.5)
    )
    between = [message.desired.positions[0] for message in feedback]
    assert between == sorted(between)
    assert any(0.1 < position < 0.4 for position in between)

    refused = client.send_goal_async(FollowJointTrajectory.Goal())
    assert wait_until(refused.done)
    assert not refused.result().accepted
    long = client.send_goal_async(goal_for(9.0, 60))
    assert wait_until(long.done)
    cancelled = long.result().cancel_goal_async()
    ended = long.result().get_result_async()
    assert wait_until(lambda: cancelled.done() and ended.done(), 10)
    assert ended.result().status == 5  # CANCELED
    query = robot.bench.call(
        QueryTrajectoryState,
        "/arm/query_state",
        QueryTrajectoryState.Request(time=robot.bench.stamp()),
    )
    assert query.success
    assert query.position[0] < 2.0


def test_an_arm_follows_the_topic_and_replaces_a_goal(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    states = robot.bench.watch(JointTrajectoryControllerState, "/arm/controller_state")
    robot.start("arm", "joint_trajectory_controller/JointTrajectoryController", ARM)
    client: Any = ActionClient(
        robot.bench.watcher, FollowJointTrajectory, "/arm/follow_joint_trajectory"
    )
    assert client.wait_for_server()
    begin_later = hold_executions(monkeypatch)
    accepted = client.send_goal_async(goal_for(9.0, 60))
    assert wait_until(accepted.done)
    ended = accepted.result().get_result_async()
    robot.bench.publisher(JointTrajectory, "/arm/joint_trajectory").publish(trajectory(-0.25, 1))
    assert wait_until(
        lambda: bool(states) and states[-1].feedback.positions[0] == pytest.approx(-0.25)
    )
    begin_later()
    assert wait_until(ended.done)
    assert ended.result().status == 6  # ABORTED
    seen = len(states)
    assert wait_until(lambda: len(states) > seen + 1)
    assert states[-1].feedback.positions[0] == pytest.approx(-0.25)


def test_a_gripper_that_is_deactivated_ends_a_goal_that_was_just_accepted(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    kind = "position_controllers/GripperActionController"
    robot.start("gripper", kind, {"joint": "elbow", "goal_tolerance": 0})
    client: Any = ActionClient(robot.bench.watcher, GripperCommand, "/gripper/gripper_cmd")
    assert client.wait_for_server()
    begin_later = hold_executions(monkeypatch)
    accepted = client.send_goal_async(GripperCommand.Goal())
    assert wait_until(accepted.done)
    assert robot.switch([], ["gripper"]).ok
    begin_later()
    ended = accepted.result().get_result_async()
    assert wait_until(ended.done)
    assert ended.result().status == 6  # ABORTED


def hold_executions(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Hold the executions of goals, as on a busy machine; return a function that starts them."""
    held: list[Callable[[], None]] = []
    begin = ActionServer.notify_execute

    def hold(*arguments: Any) -> None:
        held.append(partial(begin, *arguments))

    monkeypatch.setattr(ActionServer, "notify_execute", hold)

    def begin_all() -> None:
        for start in held:
            start()

    return begin_all


def test_commands_are_passed_on(robot: Robot, logged: list[Any]) -> None:
    states = robot.bench.watch(JointState, "/joint_states")
    robot.start("joint_states", "joint_state_broadcaster/JointStateBroadcaster")
    settings = {"joints": ["elbow"], "interface_name": "position"}
    robot.start("elbow", "forward_command_controller/ForwardCommandController", settings)
    publisher = robot.bench.publisher(Float64MultiArray, "/elbow/commands")
    publisher.publish(Float64MultiArray(data=[0.75]))
    publisher.publish(Float64MultiArray(data=[math.nan]))
    publisher.publish(Float64MultiArray(data=[0.1, 0.2]))
    assert wait_until(lambda: bool(states) and states[-1].position[2] == 0.75)
    text = "command has values that are not finite: [nan]"
    assert wait_until(lambda: any(record.message == text for record in logged))
