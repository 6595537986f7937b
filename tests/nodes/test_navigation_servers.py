"""Tests of the nodes that plan, smooth, limit and guard, each on its own."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tests.conftest import wait_until
from tests.nodes.conftest import arrives
from zbot.action import ActionClient
from zbot.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from zbot.tf2 import StaticTransformBroadcaster
from zbot_nodes.navigation.collision_monitor import CollisionMonitor
from zbot_nodes.navigation.grids.geometry import GridGeometry, grid_message
from zbot_nodes.navigation.lifecycle_manager import LifecycleManager
from zbot_nodes.navigation.planner_server import PlannerServer
from zbot_nodes.navigation.robot_frames import pose_message, transform_message
from zbot_nodes.navigation.slam_toolbox_node import Mapper
from zbot_nodes.navigation.smoother_server import SmootherServer
from zbot_nodes.navigation.velocity_smoother import VelocitySmoother
from zbot_nodes.navigation.waypoint_follower import WaypointFollower
from zbot_nodes.robot.pose import Pose

from action_msgs.msg import GoalStatus  # isort: skip
from builtin_interfaces.msg import Time  # isort: skip
from geometry_msgs.msg import Twist, TwistStamped  # isort: skip
from nav2_msgs.action import ComputePathToPose, FollowWaypoints, SmoothPath  # isort: skip
from nav2_msgs.msg import CollisionMonitorState  # isort: skip
from nav2_msgs.srv import ClearEntireCostmap, GetCostmap, IsPathValid  # isort: skip
from nav_msgs.msg import OccupancyGrid, Path  # isort: skip
from sensor_msgs.msg import LaserScan  # isort: skip
from std_msgs.msg import Bool  # isort: skip

if TYPE_CHECKING:
    from tests.nodes.conftest import Bench

KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
GEOMETRY = GridGeometry(-1.0, -1.0, 0.1, 40, 60)


def start(bench: Bench, make: Any, parameters: dict[str, Any] | None = None) -> Any:
    """Start a managed node, and configure and activate it."""
    node: Any = bench.run(make, parameters)
    node.trigger_configure()
    node.trigger_activate()
    return node


def map_with_wall(bench: Bench) -> None:
    """Publish a map with a wall that has a gap, and a robot at the place (0, 0)."""
    cells = np.zeros(GEOMETRY.shape, np.int8)
    cells[:30, 30] = 100
    message = grid_message(cells, GEOMETRY, "map", Time())
    bench.watcher.create_publisher(OccupancyGrid, "/map", KEPT).publish(message)
    broadcaster = StaticTransformBroadcaster(bench.watcher)
    broadcaster.sendTransform(transform_message("map", "base_link", Pose(), bench.stamp()))


def ask(bench: Bench, kind: Any, name: str, goal: Any) -> Any:
    """Send a goal, and return the response with its result."""
    client = ActionClient[Any, Any, Any](bench.watcher, kind, name)
    assert client.wait_for_server(10)
    sent = client.send_goal_async(goal)
    assert wait_until(sent.done, 10)
    handle: Any = sent.result()
    result = handle.get_result_async()
    assert wait_until(result.done, 10)
    return result.result()


def goal_at(x: float, y: float) -> Any:
    return ComputePathToPose.Goal(goal=pose_message(Pose(x, y), "map", Time()))


def test_a_planner_finds_the_way_around_a_wall(bench: Bench) -> None:
    map_with_wall(bench)
    node = start(bench, PlannerServer)
    assert arrives(lambda: node.costmap.costs is not None)
    found = ask(bench, ComputePathToPose, "compute_path_to_pose", goal_at(4.0, 0.0))
    assert found.status == GoalStatus.STATUS_SUCCEEDED
    places = [(pose.pose.position.x, pose.pose.position.y) for pose in found.result.path.poses]
    assert places[0] == (0.0, 0.0)
    assert places[-1] == (4.0, 0.0)
    assert max(y for _, y in places) > 2
    request = IsPathValid.Request(path=found.result.path)
    assert bench.call(IsPathValid, "/is_path_valid", request).is_valid


@pytest.mark.parametrize(
    ("place", "code"),
    [
        ((40.0, 0.0), ComputePathToPose.Result.GOAL_OUTSIDE_MAP),
        ((2.05, 0.0), ComputePathToPose.Result.GOAL_OCCUPIED),
    ],
)
def test_a_planner_says_why_there_is_no_path(
    bench: Bench, place: tuple[float, float], code: int
) -> None:
    map_with_wall(bench)
    node = start(bench, PlannerServer, {"GridBased.tolerance": 0.0})
    assert arrives(lambda: node.costmap.costs is not None)
    found = ask(bench, ComputePathToPose, "compute_path_to_pose", goal_at(*place))
    assert found.status == GoalStatus.STATUS_ABORTED
    assert found.result.error_code == code
    assert found.result.error_msg


def test_a_costmap_is_read_and_cleared_by_services(bench: Bench) -> None:
    map_with_wall(bench)
    node = start(bench, PlannerServer)
    assert arrives(lambda: node.costmap.costs is not None)
    seen = bench.watch(OccupancyGrid, "/global_costmap/costmap", KEPT)
    found = bench.call(GetCostmap, "/global_costmap/get_costmap", GetCostmap.Request()).map
    assert (found.metadata.size_x, found.metadata.size_y) == (60, 40)
    assert max(found.data) == 254
    name = "/global_costmap/clear_entirely_global_costmap"
    assert bench.call(ClearEntireCostmap, name, ClearEntireCostmap.Request()).success
    assert arrives(lambda: seen)
    assert max(seen[0].data) == 100


def test_parameters_without_effect_are_named_in_one_line(bench: Bench, logged: list[Any]) -> None:
    start(bench, SmootherServer, {"b.plugin": "x", "a.critic": 2.0, "costmap_topic": "costs"})
    lines = [record.message for record in logged if "without effect" in record.message]
    assert lines == ["parameters without effect: a.critic, b.plugin"]


def test_a_smoother_takes_the_corners_off(bench: Bench) -> None:
    start(bench, SmootherServer)
    places = [Pose(x / 10, 0.0) for x in range(10)] + [Pose(1.0, y / 10) for y in range(10)]
    path = Path()
    path.header.frame_id = "map"
    path.poses = [pose_message(place, "map", Time()) for place in places]
    found = ask(bench, SmoothPath, "smooth_path", SmoothPath.Goal(path=path)).result
    assert found.was_completed
    corner = min(
        math.dist((pose.pose.position.x, pose.pose.position.y), (1.0, 0.0))
        for pose in found.path.poses
    )
    assert corner > 0.05


def test_velocities_change_as_fast_as_the_acceleration_allows(bench: Bench) -> None:
    sent = bench.watch(Twist, "/cmd_vel_smoothed")
    start(bench, VelocitySmoother, {"max_accel": [1.0, 0.0, 1.0], "smoothing_frequency": 50.0})
    publisher = bench.publisher(Twist, "/cmd_vel")
    command = Twist()
    command.linear.x = 2.0
    publisher.publish(command)
    assert arrives(lambda: sent and sent[-1].linear.x == 0.5)
    steps = np.diff([0.0, *(message.linear.x for message in sent)])
    assert steps.max() <= 0.021
    assert arrives(lambda: sent[-1].linear.x == 0.0)


def test_a_stamped_command_is_smoothed_as_a_stamped_one(bench: Bench) -> None:
    sent = bench.watch(TwistStamped, "/cmd_vel_smoothed")
    start(bench, VelocitySmoother, {"enable_stamped_cmd_vel": True})
    command = TwistStamped()
    command.twist.angular.z = 0.1
    bench.publisher(TwistStamped, "/cmd_vel").publish(command)
    assert arrives(lambda: sent and sent[-1].twist.angular.z == 0.1)


def scan_ahead(bench: Bench, away_m: float) -> LaserScan:
    """Return a scan with an obstacle ahead."""
    scan = LaserScan(range_min=0.05, range_max=10.0, angle_min=-0.1, angle_increment=0.01)
    scan.header.frame_id, scan.header.stamp = "base_footprint", bench.stamp()
    scan.ranges = [away_m] * 21
    return scan


@pytest.mark.parametrize(
    ("action", "away_m", "speed"),
    [("stop", 0.3, 0.0), ("slowdown", 0.3, 0.2), ("stop", 2.0, 0.4), ("approach", 0.9, 0.3)],
)
def test_a_guarded_area_makes_the_robot_slower(
    bench: Bench, action: str, away_m: float, speed: float
) -> None:
    sent = bench.watch(Twist, "/cmd_vel")
    node = start(
        bench,
        CollisionMonitor,
        {
            "polygons": ["Area"],
            "Area.type": "circle",
            "Area.radius": 0.5,
            "Area.action_type": action,
            "observation_sources": ["scan"],
        },
    )
    states = bench.watch(CollisionMonitorState, "/collision_monitor_state")
    publisher = bench.publisher(LaserScan, "/scan", qos_profile_sensor_data)
    broadcaster = StaticTransformBroadcaster(bench.watcher)
    frame = transform_message("base_footprint", "scan", Pose(), bench.stamp())
    broadcaster.sendTransform(frame)
    commands = bench.publisher(Twist, "/cmd_vel_smoothed")
    command = Twist()
    command.linear.x = 0.4

    def sees() -> bool:
        publisher.publish(scan_ahead(bench, away_m))
        return bool(node.seen)

    assert arrives(sees)
    commands.publish(command)
    assert arrives(lambda: sent)
    assert sent[-1].linear.x == pytest.approx(speed, abs=0.12)
    assert arrives(lambda: bool(states) == (speed < 0.4))


def test_waypoints_that_are_missed_are_named(bench: Bench) -> None:
    start(bench, WaypointFollower)
    goal = FollowWaypoints.Goal(poses=[pose_message(Pose(1.0, 0.0), "map", Time())])
    found = ask(bench, FollowWaypoints, "follow_waypoints", goal)
    assert found.status == GoalStatus.STATUS_ABORTED
    assert found.result.error_code == FollowWaypoints.Result.STOP_ON_MISSED_WAYPOINT
    assert [missed.waypoint_index for missed in found.result.missed_waypoints] == [0]
    assert "navigate_to_pose" in found.result.error_msg


def test_a_mapper_that_nobody_configures_starts_itself(bench: Bench) -> None:
    node: Any = bench.run(Mapper)
    assert wait_until(lambda: node.is_active, 10)
    states = bench.watch(Bool, "/lifecycle_manager/managed_nodes_activated", KEPT)
    bench.run(LifecycleManager, {"node_names": ["slam_toolbox"], "autostart": True})
    assert wait_until(lambda: bool(states) and states[-1].data, 15), "a late manager starts it too"


def test_a_mapper_says_that_it_does_not_localize(bench: Bench, logged: list[Any]) -> None:
    mapper: Any = bench.run(Mapper)
    mapper.trigger_configure()
    assert not [record for record in logged if "is left out" in record.message]
    localizer: Any = bench.run(Mapper, {"mode": "localization"})
    localizer.trigger_configure()
    expected = "the mode 'localization' is left out: a new map begins where the robot is"
    assert any(record.message.startswith(expected) for record in logged)


def test_a_manager_leaves_out_nodes_that_zbot_or_the_launch_does_not_have(
    bench: Bench, logged: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ZBOT_LEFT_OUT", "/driver /other")
    bench.run(SmootherServer)
    states = bench.watch(Bool, "/lifecycle_manager/managed_nodes_activated", KEPT)
    names = ["smoother_server", "docking_server", "keepout_costmap_filter_info_server", "driver"]
    bench.run(LifecycleManager, {"node_names": names, "autostart": True})
    assert wait_until(lambda: bool(states) and states[-1].data, 15)
    expected = "docking_server, keepout_costmap_filter_info_server, driver"
    assert any(record.message.endswith(f": {expected}") for record in logged)
