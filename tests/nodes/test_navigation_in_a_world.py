"""A robot maps a room, is localised in the map, and drives to goals."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from zbot.qos import DurabilityPolicy, QoSProfile

from geometry_msgs.msg import PoseWithCovarianceStamped  # isort: skip
from nav_msgs.msg import OccupancyGrid  # isort: skip

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.navigation_world import NavigationWorld

pytest.importorskip("mujoco", reason="the simulator needs the extra `sim`")

EXAMPLES = Path(__file__).parents[2] / "examples"
KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def world(domain: int) -> Iterator[NavigationWorld]:
    """Return the room, with all nodes that drive the robot."""
    from benchmarks.navigation_world import NavigationWorld, start_drivers  # noqa: PLC0415 - needs the extra

    found = NavigationWorld("room", domain)
    start_drivers(found)
    yield found
    found.close()


def test_a_robot_maps_a_room_and_drives_to_goals_in_the_map(world: NavigationWorld) -> None:
    from zbot_nodes.navigation.amcl import Amcl  # noqa: PLC0415 - needs numpy
    from zbot_nodes.navigation.slam_toolbox_node import Mapper  # noqa: PLC0415 - as above

    maps: list[Any] = []
    world.client_node.create_subscription(OccupancyGrid, "map", maps.append, KEPT)
    mapper = world.add(Mapper)
    assert world.wait(lambda: bool(maps), 10)
    world.run(2)
    place = world.in_map(1.5, -1.0)
    assert world.go(*place)
    assert world.away_m(*place) < 0.3
    world.run(2.5)
    free = sum(cell == 0 for cell in maps[-1].data) * 0.05**2
    assert 24 < free < 32  # the room has 29 square metres
    mapper.trigger_deactivate()

    poses: list[Any] = []
    # Ten, because the pose of the first scan may come before the start has been taken.
    world.client_node.create_subscription(PoseWithCovarianceStamped, "amcl_pose", poses.append, 10)
    start = world.in_map(*world.true_pose()[:2])
    parameters = {
        "initial_pose.x": start[0] + 0.2,
        "initial_pose.y": start[1],
        "initial_pose.yaw": world.true_pose()[2],
    }
    publisher = world.client_node.create_publisher(OccupancyGrid, "map", KEPT)
    publisher.publish(maps[-1])
    world.add(Amcl, parameters)
    assert world.wait(lambda: len(poses) > 1, 10)
    assert world.go(*world.in_map(0.0, 0.0), 1.0)
    assert world.away_m(*world.in_map(0.0, 0.0)) < 0.3
    found = poses[-1].pose.pose.position
    assert world.away_m(found.x, found.y) < 0.2
    assert not world.touched


def test_a_goal_outside_of_the_map_is_refused_with_a_reason(world: NavigationWorld) -> None:
    from zbot_nodes.navigation.slam_toolbox_node import Mapper  # noqa: PLC0415 - needs numpy

    world.add(Mapper)
    world.run(3)
    assert not world.go(50.0, 0.0)
    assert "is not in the map" in world.error


def test_an_example_finds_its_way_out_of_the_maze(domain: int) -> None:
    from benchmarks.navigation_world import NavigationWorld  # noqa: PLC0415 - needs the extra

    world = NavigationWorld("maze", domain, steps=10)
    program = world.add(runpy.run_path(str(EXAMPLES / "maze.py"))["Maze"])
    assert world.wait(lambda: program.is_outside, 300)
    x, y, _ = world.true_pose()
    assert max(abs(x), abs(y)) > 2.4
    assert not world.touched
    world.close()
