"""Tests of the simulated room and of what the robot's sensors measure in it."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from zbot_nodes.robot.pose import pose_of, to_quaternion, to_yaw, turn_to
from zbot_nodes.robot.world import OBSTACLES, ROOM, distance, is_free
from zbot_nodes.robot_navigation import PATROL

from nav_msgs.msg import Odometry

ANGLES = st.floats(-math.pi, math.pi)


@pytest.mark.parametrize(
    ("x", "y", "degrees", "expected"),
    [
        (0, 0, 0, 4.0),
        (0, 0, 90, 2.5),
        (0, 0, 180, 2.0),
        (0, 0, -90, 2.5),
        (0, 0, 45, 2.5 * math.sqrt(2)),
        (2, 0, 90, 1.0),  # a box
        (2, 2, -90, 0.4),  # its other side
        (-1, 0, -90, 1.3),
        (10, 10, 45, math.inf),
    ],
)
def test_distance_ends_at_the_first_wall(
    x: float, y: float, degrees: float, expected: float
) -> None:
    assert distance(x, y, math.radians(degrees)) == pytest.approx(expected)


@given(st.floats(-1.99, 3.99), st.floats(-2.49, 2.49), ANGLES)
def test_every_measured_point_is_on_a_wall(x: float, y: float, angle: float) -> None:
    far = distance(x, y, angle)
    assert 0 < far < math.hypot(6, 5) + 1e-6
    hit_x, hit_y = x + far * math.cos(angle), y + far * math.sin(angle)
    assert any(
        math.isclose(hit_x, wall, abs_tol=1e-6) and box.bottom - 1e-6 <= hit_y <= box.top + 1e-6
        for box in (ROOM, *OBSTACLES)
        for wall in (box.left, box.right)
    ) or any(
        math.isclose(hit_y, wall, abs_tol=1e-6) and box.left - 1e-6 <= hit_x <= box.right + 1e-6
        for box in (ROOM, *OBSTACLES)
        for wall in (box.bottom, box.top)
    )


@pytest.mark.parametrize(
    ("x", "y", "expected"),
    [(0, 0, True), (3.79, 0, True), (3.81, 0, False), (2, 1.3, False), (1.6, 1.3, False)],
)
def test_the_robot_needs_room_on_all_sides(x: float, y: float, expected: bool) -> None:
    assert is_free(x, y) is expected


def test_the_path_of_the_patrol_is_free() -> None:
    for (from_x, from_y), (to_x, to_y) in pairwise([(0.0, 0.0), *PATROL, PATROL[0]]):
        for step in range(101):
            x = from_x + (to_x - from_x) * step / 100
            y = from_y + (to_y - from_y) * step / 100
            assert is_free(x, y), (x, y)


@given(ANGLES)
def test_a_heading_survives_its_quaternion(yaw: float) -> None:
    assert turn_to(to_yaw(to_quaternion(yaw)) - yaw) == pytest.approx(0, abs=1e-9)


@given(st.floats(-100, 100))
def test_the_shorter_turn_ends_in_the_same_direction(angle: float) -> None:
    turn = turn_to(angle)
    assert -math.pi <= turn <= math.pi
    assert math.cos(turn) == pytest.approx(math.cos(angle), abs=1e-9)
    assert math.sin(turn) == pytest.approx(math.sin(angle), abs=1e-9)


def test_a_pose_is_read_from_a_message() -> None:
    msg = Odometry()
    msg.pose.pose.position.x, msg.pose.pose.position.y = 1.0, 2.0
    msg.pose.pose.orientation = to_quaternion(0.5)
    assert pose_of(msg) == pytest.approx((1.0, 2.0, 0.5))
