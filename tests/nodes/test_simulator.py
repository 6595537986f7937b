"""Tests of the simulator's node: its topics, its time and its services."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.nodes.conftest import arrives
from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from zbot.tf2.rigid import rotate
from zbot.view.displays import marker as markers
from zbot.view.displays.interactive_markers import InteractiveMarkers
from zbot.view.shape import Gizmo

from geometry_msgs.msg import Twist, TwistStamped  # isort: skip
from nav_msgs.msg import Odometry  # isort: skip
from ros_gz_interfaces.msg import Contacts  # isort: skip
from rosgraph_msgs.msg import Clock  # isort: skip
from sensor_msgs.msg import CameraInfo, Image, Imu, JointState, LaserScan  # isort: skip
from simulation_interfaces.msg import Result, SimulationState  # isort: skip
from simulation_interfaces.srv import (  # isort: skip
    DeleteEntity,
    GetEntities,
    GetEntityState,
    GetSimulationState,
    GetSimulatorFeatures,
    ResetSimulation,
    SetEntityState,
    SetSimulationState,
    SpawnEntity,
    StepSimulation,
)
from builtin_interfaces.msg import Duration  # isort: skip
from std_msgs.msg import Float64MultiArray, String  # isort: skip
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint  # isort: skip
from tf2_msgs.msg import TFMessage  # isort: skip
from visualization_msgs.msg import (  # isort: skip
    InteractiveMarkerFeedback,
    InteractiveMarkerUpdate,
    MarkerArray,
)
from visualization_msgs.srv import GetInteractiveMarkers  # isort: skip

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.conftest import Program
    from tests.nodes.conftest import Bench
    from zbot.simulation.node.simulator import Simulator

    Simulate = Callable[..., Simulator]

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def simulate(bench: Bench) -> Simulate:
    """Return a function that starts a simulator of the room with these robots."""
    from zbot.simulation.node.pace import Pace  # noqa: PLC0415 - needs the extra
    from zbot.simulation.node.program import Options, robots_of  # noqa: PLC0415 - as above
    from zbot.simulation.node.simulator import Simulator  # noqa: PLC0415 - as above
    from zbot.simulation.world import World  # noqa: PLC0415 - as above
    from zbot.simulation.worlds.file import find_world  # noqa: PLC0415 - as above

    def start(*, rate: float | None = 1.0, **options: Any) -> Simulator:
        def make(**node_options: Any) -> zbot.Node:
            found = find_world(options.get("world", "room"))
            world = World(found.spec)
            node = Simulator(world, Pace(rate), **node_options)
            node.add_robots(robots_of(Options(**options), world, found.start))
            if options.get("has_handles"):
                node.show_handles()
            return node

        return bench.run(make)  # type: ignore[return-value]

    return start


def call(bench: Bench, type_: type[Any], name: str, **fields: Any) -> Any:
    """Call a service of the simulator. Its result must be good."""
    response = bench.call(type_, name, type_.Request(**fields))
    assert response.result.result == Result.RESULT_OK, response.result.error_message
    return response


def test_a_robot_publishes_everything_in_its_frames(bench: Bench, simulate: Simulate) -> None:
    topics = {
        "/odom": (Odometry, "odom"),
        "/scan": (LaserScan, "base_scan"),
        "/imu": (Imu, "imu_link"),
        "/camera/image_raw": (Image, "camera_optical_frame"),
        "/camera/depth/image_raw": (Image, "camera_optical_frame"),
        "/camera/camera_info": (CameraInfo, "camera_optical_frame"),
        "/ground_truth": (Odometry, "world"),
        "/bumper": (Contacts, "world"),
    }
    heard = {
        name: bench.watch(type_, name, qos_profile_sensor_data)
        for name, (type_, _) in topics.items()
    }
    joints = bench.watch(JointState, "/joint_states")
    simulate()
    assert arrives(lambda: all(heard.values()) and joints), [
        name for name in heard if not heard[name]
    ]
    for name, (_, frame) in topics.items():
        assert heard[name][0].header.frame_id == frame
    assert joints[0].name == ["wheel_left_joint", "wheel_right_joint"]
    scan = heard["/scan"][0]
    assert len(scan.ranges) == 360
    assert scan.ranges[0] == pytest.approx(4.02, abs=0.05)
    assert len(heard["/camera/image_raw"][0].data) == 160 * 120 * 3


def test_frames_lead_from_the_world_to_every_link(bench: Bench, simulate: Simulate) -> None:
    moving, fixed = bench.watch(TFMessage, "/tf"), bench.watch(TFMessage, "/tf_static", LATCHED)
    simulate()
    assert arrives(lambda: moving and any(msg.transforms for msg in fixed))
    parents = {
        frame.child_frame_id: frame.header.frame_id
        for message in (moving[-1], *fixed)
        for frame in message.transforms
    }
    for link in ("base_scan", "camera_optical_frame", "wheel_left_link", "imu_link"):
        while link in parents:
            link = parents[link]  # noqa: PLW2901 - up to the root
        assert link == "world"


def test_a_robot_drives_as_commanded_and_stops_when_commands_stop(
    bench: Bench, simulate: Simulate
) -> None:
    odometry = bench.watch(Odometry, "/odom")
    simulate()
    wheel = bench.publisher(Twist, "/cmd_vel")
    command = Twist()
    command.linear.x = 0.4

    def drives() -> bool:
        wheel.publish(command)
        return bool(odometry) and odometry[-1].twist.twist.linear.x > 0.35

    assert arrives(drives)
    stamp = odometry[-1].header.stamp
    assert arrives(lambda: abs(odometry[-1].twist.twist.linear.x) < 0.01)
    end = odometry[-1].header.stamp
    assert 0.4 < end.sec - stamp.sec + (end.nanosec - stamp.nanosec) / 1e9 < 2.0


@pytest.mark.parametrize("value", [math.nan, math.inf, 1e300])
def test_the_world_survives_senseless_commands(
    bench: Bench, simulate: Simulate, value: float
) -> None:
    odometry = bench.watch(Odometry, "/odom")
    node = simulate(rate=None)
    command = Twist()
    command.linear.x = command.angular.z = value
    bench.publisher(Twist, "/cmd_vel").publish(command)
    before = len(odometry)
    assert arrives(lambda: len(odometry) > before + 100)
    assert all(map(math.isfinite, node.world.robots["robot"].pose.translation))
    assert all(math.isfinite(msg.pose.pose.position.x) for msg in odometry)


def test_commands_may_have_a_stamp(bench: Bench, simulate: Simulate) -> None:
    odometry = bench.watch(Odometry, "/odom")
    wheel = bench.watcher.create_publisher(TwistStamped, "/cmd_vel", 10)
    simulate()
    command = TwistStamped()
    command.twist.angular.z = 1.0

    def turns() -> bool:
        wheel.publish(command)
        return bool(odometry) and odometry[-1].twist.twist.angular.z > 0.8

    assert arrives(turns)


def test_several_robots_have_namespaces_and_frames_of_their_own(
    bench: Bench, simulate: Simulate
) -> None:
    scans = bench.watch(LaserScan, "/robot3/scan", qos_profile_sensor_data)
    moving = bench.watch(TFMessage, "/tf")
    texts = bench.watch(String, "/robot2/robot_description", LATCHED)
    simulate(count=3)
    assert arrives(lambda: scans and texts and len(moving) > 6)
    assert scans[0].header.frame_id == "robot3/base_scan"
    children = {frame.child_frame_id for message in moving for frame in message.transforms}
    assert {f"robot{number}/base_footprint" for number in (1, 2, 3)} <= children
    assert '<link name="robot2/base_link">' in texts[0].data
    assert '<parent link="robot2/base_footprint"/>' in texts[0].data


def test_the_world_is_shown_by_markers(bench: Bench, simulate: Simulate) -> None:
    walls = bench.watch(MarkerArray, "/simulation/world", LATCHED)
    simulate()
    assert arrives(lambda: walls)
    shown = [marker for marker in walls[0].markers if marker.action == marker.ADD]
    assert len(shown) == 7, "a floor, four walls and two boxes"
    assert {marker.header.frame_id for marker in shown} == {"world"}
    display = markers.MarkerArray("/simulation/world")
    display.take(walls[0])
    assert len(display.items) == 7
    assert not display.notice


def test_boxes_that_are_pushed_are_shown_at_their_new_place(
    bench: Bench, simulate: Simulate
) -> None:
    things = bench.watch(MarkerArray, "/simulation/things", LATCHED)
    node = simulate(world="arena")
    assert arrives(lambda: things)
    request = SetEntityState.Request(entity="box1", set_pose=True)
    request.state.pose.position.x, request.state.pose.position.z = 0.6, 0.2
    request.state.pose.orientation.w = 1.0
    assert bench.call(SetEntityState, "/set_entity_state", request).result.result == 1
    assert arrives(lambda: 0.6 in {round(mark.pose.position.x, 2) for mark in things[-1].markers})
    assert "box1" in node.world.things


def test_the_time_of_the_world_is_on_the_clock(bench: Bench, simulate: Simulate) -> None:
    times = bench.watch(Clock, "/clock")
    simulate(rate=None)
    assert arrives(lambda: times and times[-1].clock.sec >= 5)
    stamps = [message.clock.sec * 10**9 + message.clock.nanosec for message in times]
    assert stamps == sorted(stamps)


def test_an_arm_takes_trajectories_and_positions(bench: Bench, simulate: Simulate) -> None:
    states = bench.watch(JointState, "/joint_states")
    simulate(robots=("arm",), rate=None)
    trajectories = bench.publisher(JointTrajectory, "/arm_controller/joint_trajectory")
    point = JointTrajectoryPoint(positions=[0.5], time_from_start=Duration(sec=1))
    trajectories.publish(JointTrajectory(joint_names=["shoulder_joint"], points=[point]))
    assert arrives(lambda: states and states[-1].position[0] == pytest.approx(0.5, abs=0.02))
    commands = bench.publisher(Float64MultiArray, "/arm_controller/commands")
    commands.publish(Float64MultiArray(data=[1.0]))  # too few
    commands.publish(Float64MultiArray(data=[0.0, 0.3, 0.0, 0.0, 0.01, 0.01]))
    assert arrives(lambda: states[-1].position[1] == pytest.approx(0.3, abs=0.02))


def test_a_user_moves_a_robot_by_its_handle_and_puts_everything_back(
    bench: Bench, simulate: Simulate
) -> None:
    updates = bench.watch(InteractiveMarkerUpdate, "/simulation/handles/update", LATCHED)
    simulator = simulate(has_handles=True)
    feedback = bench.publisher(InteractiveMarkerFeedback, "/simulation/handles/feedback")
    shown = bench.call(
        GetInteractiveMarkers,
        "/simulation/handles/get_interactive_markers",
        GetInteractiveMarkers.Request(),
    )
    assert [marker.name for marker in shown.markers] == ["robot"]
    display = InteractiveMarkers("/simulation/handles/update")
    display.take(shown)
    handle = display.items["robot/0/handle"]
    assert isinstance(handle.shapes[0], Gizmo)
    assert handle.shapes[0].axes == (False, True, True)
    assert rotate(handle.pose.rotation, (1.0, 0.0, 0.0)) == pytest.approx((0, 0, 1), abs=1e-6)
    user: dict[str, Any] = {"client_id": "user", "marker_name": "robot", "control_name": "move"}
    moved = InteractiveMarkerFeedback(**user, event_type=InteractiveMarkerFeedback.POSE_UPDATE)
    moved.pose.position.x, moved.pose.position.z = 1.5, 9.0
    moved.pose.orientation.z = moved.pose.orientation.w = 0.7071
    feedback.publish(moved)
    robot = simulator.world.robots["robot"]
    assert arrives(lambda: robot.pose.translation[0] == pytest.approx(1.5, abs=0.01))
    assert robot.pose.translation[2] == pytest.approx(0.0, abs=0.01), "it stays on the floor"
    assert robot.pose.rotation[2] == pytest.approx(0.7071, abs=0.01)
    moved.pose.position.x = math.nan
    feedback.publish(moved)
    (entry,) = shown.markers[0].menu_entries
    assert entry.title == "Put everything back"
    select = InteractiveMarkerFeedback.MENU_SELECT
    feedback.publish(InteractiveMarkerFeedback(**user, event_type=select, menu_entry_id=entry.id))
    assert arrives(lambda: robot.pose.translation[0] == pytest.approx(0.0, abs=0.01))
    assert arrives(lambda: updates)


def test_a_second_simulator_of_a_domain_is_refused(simulate: Simulate) -> None:
    simulate()
    with pytest.raises(zbot.ZbotError, match="publishes /clock in this domain already"):
        simulate()


def test_entities_are_listed_and_moved(bench: Bench, simulate: Simulate) -> None:
    simulate()
    assert call(bench, GetEntities, "/get_entities").entities == ["robot"]
    request = SetEntityState.Request(entity="robot", set_pose=True)
    request.state.pose.position.x, request.state.pose.orientation.w = 1.0, 1.0
    assert bench.call(SetEntityState, "/set_entity_state", request).result.result == 1
    state = call(bench, GetEntityState, "/get_entity_state", entity="robot").state
    assert state.pose.position.x == pytest.approx(1.0, abs=0.01)
    assert state.header.frame_id == "world"
    request.state.pose.orientation.w = math.nan
    response = bench.call(SetEntityState, "/set_entity_state", request)
    assert response.result.result == SetEntityState.Response.INVALID_POSE
    unknown = bench.call(
        GetEntityState, "/get_entity_state", GetEntityState.Request(entity="nobody")
    )
    assert unknown.result.result == Result.RESULT_NOT_FOUND


def test_robots_are_spawned_and_deleted(bench: Bench, simulate: Simulate) -> None:
    simulate()
    request = SpawnEntity.Request(name="other", entity_namespace="other")
    request.entity_resource.uri = "two_wheeled"
    request.initial_pose.pose.position.x, request.initial_pose.pose.orientation.w = 1.0, 1.0
    response = bench.call(SpawnEntity, "/spawn_entity", request)
    assert response.result.result == Result.RESULT_OK, response.result.error_message
    scans = bench.watch(LaserScan, "/other/scan", qos_profile_sensor_data)
    assert arrives(lambda: scans)
    again = bench.call(SpawnEntity, "/spawn_entity", request)
    assert again.result.result == SpawnEntity.Response.NAME_NOT_UNIQUE
    request.allow_renaming = True
    request.initial_pose.pose.position.x = -1.0
    assert bench.call(SpawnEntity, "/spawn_entity", request).entity_name == "other_2"
    call(bench, DeleteEntity, "/delete_entity", entity="other")
    assert call(bench, GetEntities, "/get_entities").entities == ["robot", "other_2"]
    call(bench, ResetSimulation, "/reset_simulation")
    assert call(bench, GetEntities, "/get_entities").entities == ["robot"]


def test_a_damaged_description_is_not_spawned(bench: Bench, simulate: Simulate) -> None:
    simulate()
    request = SpawnEntity.Request(name="broken")
    request.entity_resource.resource_string = "<robot name='a'><link/></robot>"
    request.initial_pose.pose.orientation.w = 1.0
    response = bench.call(SpawnEntity, "/spawn_entity", request)
    assert response.result.result == SpawnEntity.Response.RESOURCE_PARSE_ERROR
    assert "a <link> has no name" in response.result.error_message


def test_a_program_that_spawns_without_end_is_refused_at_the_limit(
    bench: Bench, simulate: Simulate, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("zbot.simulation.world._MOST_ROBOTS", 5)
    simulate()
    request = SpawnEntity.Request(name="ball", allow_renaming=True)
    request.entity_resource.resource_string = (
        "<robot name='ball'><link name='l'><collision><geometry><sphere radius='0.1'/></geometry>"
        "</collision></link></robot>"
    )
    request.initial_pose.pose.orientation.w = 1.0
    answers = [bench.call(SpawnEntity, "/spawn_entity", request).result for _ in range(30)]
    assert [answer.result for answer in answers[:4]] == [Result.RESULT_OK] * 4
    assert {answer.error_message for answer in answers[4:]} == {
        "the world has 5 robots, which is the limit"
    }


def test_a_killed_simulator_leaves_nothing_to_the_next_one(start: Callable[..., Program]) -> None:
    for _ in range(2):
        simulator = start("zbot", "sim", "--headless")
        simulator.wait_for("has the robots: robot")
        simulator.process.kill()
        simulator.process.wait(5)
        assert "Traceback" not in simulator.output


def test_the_simulation_pauses_steps_and_resets(bench: Bench, simulate: Simulate) -> None:
    node = simulate()
    state = SetSimulationState.Request()
    state.state.state = SimulationState.STATE_PAUSED
    assert bench.call(SetSimulationState, "/set_simulation_state", state).result.result == 1
    again = bench.call(SetSimulationState, "/set_simulation_state", state)
    assert again.result.result == SetSimulationState.Response.ALREADY_IN_TARGET_STATE
    found = call(bench, GetSimulationState, "/get_simulation_state")
    assert found.state.state == SimulationState.STATE_PAUSED
    before = node.world.steps
    call(bench, StepSimulation, "/step_simulation", steps=10)
    assert node.world.steps == before + 10
    call(bench, ResetSimulation, "/reset_simulation")
    assert node.world.steps == 0


def test_features_name_what_the_services_do(bench: Bench, simulate: Simulate) -> None:
    simulate()
    response = bench.call(
        GetSimulatorFeatures, "/get_simulator_features", GetSimulatorFeatures.Request()
    )
    features = response.features
    assert features.SPAWNING in features.features
    assert features.spawn_formats == ["urdf"]
