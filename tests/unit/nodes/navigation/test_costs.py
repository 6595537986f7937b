"""Tests of costs, of outlines, of the search of paths and of the pursuit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from zbot_nodes.navigation.followed_path import FollowedPath, GoalCheck, ProgressCheck
from zbot_nodes.navigation.grids.costs import Inflation, ObstacleLayer, to_occupancy
from zbot_nodes.navigation.grids.footprint import Footprint, footprint_of, leads_away
from zbot_nodes.navigation.grids.geometry import GridGeometry
from zbot_nodes.navigation.grids.path import length, smooth
from zbot_nodes.navigation.grids.path_search import find_path
from zbot_nodes.navigation.grids.pursuit import PursuitRules, Velocity, ahead, arc
from zbot_nodes.navigation.grids.rays import Rays, moved
from zbot_nodes.robot.pose import Pose, turn_to

GRID = GridGeometry(0.0, 0.0, 0.1, 40, 60)
INFLATION = Inflation(0.2, radius_m=0.5, steepness=5.0)


def wall_with_gap(*, gap: bool = True) -> np.ndarray:
    """Return a wall across the grid. Its gap is at the top."""
    cells = np.zeros(GRID.shape, bool)
    cells[: 30 if gap else 40, 30] = True
    return cells


def test_costs_fall_with_the_distance_from_an_obstacle() -> None:
    costs = INFLATION.costs(wall_with_gap(), 0.1)[5, 30:38].tolist()
    assert costs[:3] == [254, 253, 253]
    assert costs[3:6] == sorted(costs[3:6], reverse=True)
    assert costs[6:] == [0, 0]


def test_costs_are_percents_in_a_message() -> None:
    assert to_occupancy(np.array([0, 1, 126, 252, 253, 254, 255], np.uint8)).tolist() == [
        *(0, 1, 49, 98, 99, 100, -1)
    ]


def test_obstacles_are_marked_and_cleared_by_rays() -> None:
    layer = ObstacleLayer(GRID)
    layer.add(Rays(np.array([1.0, 1.0]), np.array([[2.05, 1.0]]), np.array([True])))
    assert np.argwhere(layer.cells).tolist() == [[10, 20]]
    layer.add(Rays(np.array([1.0, 1.0]), np.array([[3.05, 1.0]]), np.array([True])))
    assert np.argwhere(layer.cells).tolist() == [[10, 30]]
    layer.clear(3.0, 1.0, 0.5, inside=False)
    assert layer.cells.any()
    layer.clear(3.0, 1.0, 0.5, inside=True)
    assert not layer.cells.any()


def test_a_grid_that_moves_keeps_its_obstacles_at_their_places() -> None:
    layer = ObstacleLayer(GRID)
    layer.cells[20, 30] = True
    place = GRID.centres(np.array([20]), np.array([30]))[0]
    layer.move_to(3.7, 1.5)
    assert layer.geometry.x == pytest.approx(0.7)
    assert np.argwhere(layer.cells).tolist() == [list(layer.geometry.cell(*place) or ())]
    layer.move_to(50.0, 50.0)
    assert not layer.cells.any()


def test_a_path_leads_through_the_gap_and_keeps_away_from_the_wall() -> None:
    costs = INFLATION.costs(wall_with_gap(), 0.1)
    cells = find_path(costs, (5, 5), (5, 55))
    assert cells is not None
    assert (cells[0], cells[-1]) == ((5, 5), (5, 55))
    assert max(costs[cell] for cell in cells) < 253
    steps = np.abs(np.diff(np.array(cells), axis=0)).max(axis=1)
    assert (steps == 1).all()


def test_the_path_through_an_empty_grid_is_the_shortest() -> None:
    cells = find_path(np.zeros(GRID.shape, np.uint8), (5, 5), (15, 35))
    assert cells is not None
    assert len(cells) == 31


def test_there_is_no_path_through_a_closed_wall() -> None:
    costs = INFLATION.costs(wall_with_gap(gap=False), 0.1)
    assert find_path(costs, (5, 5), (5, 55)) is None


def test_a_path_may_end_before_a_goal_that_is_occupied() -> None:
    costs = INFLATION.costs(wall_with_gap(), 0.1)
    assert find_path(costs, (5, 5), (5, 29)) is None
    cells = find_path(costs, (5, 5), (5, 29), tolerance=4)
    assert cells is not None
    assert cells[-1] == (5, 27)


def test_a_robot_that_is_too_near_to_a_wall_gets_away_from_it() -> None:
    occupied = wall_with_gap()
    costs = INFLATION.costs(occupied, 0.1)
    cells = find_path(costs, (5, 28), (5, 5))
    assert cells is not None
    assert [int(costs[cell]) for cell in cells[:2]] == [253, 152]
    wall, before, far = Pose(2.95, 0.5), Pose(2.8, 0.5), Pose(2.5, 0.5)
    assert leads_away(before, far, occupied, GRID)
    assert not leads_away(before, wall, occupied, GRID)


def test_unknown_cells_are_entered_only_if_it_is_allowed() -> None:
    costs = np.zeros(GRID.shape, np.uint8)
    costs[:, 30] = 255
    assert find_path(costs, (5, 5), (5, 55)) is not None
    assert find_path(costs, (5, 5), (5, 55), allow_unknown=False) is None


def test_a_smooth_path_is_shorter_and_touches_nothing() -> None:
    costs = INFLATION.costs(wall_with_gap(), 0.1)
    cells = find_path(costs, (5, 5), (5, 55))
    assert cells is not None
    points = GRID.centres(*np.array(cells).T)
    found = smooth(points, costs, GRID)
    assert length(found) < length(points)
    assert (found[0] == points[0]).all()
    assert (found[-1] == points[-1]).all()
    rows, columns = GRID.cells(found)
    assert np.max(costs[rows, columns]) < 253


def test_a_round_robot_touches_where_the_costs_say_so() -> None:
    costs = INFLATION.costs(wall_with_gap(), 0.1)
    robot = Footprint.circle(0.2)
    poses = [Pose(2.0, 0.5), Pose(2.7, 0.5), Pose(2.9, 0.5)]
    assert robot.touches(poses, costs, GRID) == 2
    assert robot.touches(poses[:2], costs, GRID) is None


def test_a_long_robot_touches_only_if_it_is_turned_to_the_wall() -> None:
    robot = footprint_of("[[0.5, 0.2], [0.5, -0.2], [-0.5, -0.2], [-0.5, 0.2]]", 0.0)
    assert robot.inscribed_m == pytest.approx(0.2)
    assert robot.circumscribed_m == pytest.approx(math.hypot(0.5, 0.2))
    costs = Inflation(robot.inscribed_m, 0.6).costs(wall_with_gap(), 0.1)
    assert robot.touches([Pose(2.7, 0.8, 0.0)], costs, GRID) == 0
    assert robot.touches([Pose(2.7, 0.8, math.pi / 2)], costs, GRID) is None


@pytest.mark.parametrize("text", ["[[1, 2]]", "[1, 2, 3]", "{}"])
def test_an_outline_that_is_none_is_refused(text: str) -> None:
    with pytest.raises(ValueError):  # noqa: PT011 - from several libraries
        footprint_of(text, 0.1)


def follow(points: np.ndarray, pose: Pose) -> Pose:
    """Let a robot follow a path by the rules of pursuit. Return where it is at the end."""
    rules, last, check = PursuitRules(), Velocity(), GoalCheck(0.1, 4.0)
    path = FollowedPath([Pose(*point) for point in points.tolist()])
    for _ in range(400):
        path.advance(pose)
        if check.is_reached(path, pose):
            break
        last = rules.follow(path.ahead_of(pose), last, 0.05)
        pose = pose @ arc(last, 0.05, 1.0)[-1]
    return pose


def test_a_robot_follows_a_path_around_a_corner() -> None:
    along = np.linspace(0, 2, 40)
    points = np.vstack([np.stack([along, 0 * along], 1), np.stack([2 + 0 * along, along], 1)])
    for start in (Pose(), Pose(0.0, 0.1, math.pi)):
        end = follow(points, start)
        assert math.dist(end[:2], (2, 2)) <= 0.1
        assert abs(turn_to(end.yaw - math.pi / 2)) < 0.3


def test_a_robot_that_looks_back_turns_before_it_drives() -> None:
    velocity = PursuitRules().follow(np.array([[0.0, 0.0], [-1.0, 0.1]]), Velocity(), 0.05)
    assert velocity.forward == 0
    assert velocity.turn > 0


def test_the_point_ahead_is_on_the_path_at_its_distance() -> None:
    points = np.array([[0.0, 0.0], [0.2, 0.0], [1.0, 0.0]])
    assert ahead(points, 0.5) == pytest.approx((0.5, 0.0))
    assert ahead(points, 5.0) == (1.0, 0.0)


def test_an_arc_ends_where_its_circle_leads() -> None:
    end = arc(Velocity(0.5, math.pi / 4), 2.0, 0.05)[-1]
    radius = 0.5 / (math.pi / 4)
    assert end == pytest.approx((radius, radius, math.pi / 2))


def test_the_end_of_a_path_needs_the_place_and_the_direction() -> None:
    path, check = FollowedPath([Pose(0, 0), Pose(1, 0), Pose(2, 0, 1.0)]), GoalCheck(0.2, 0.2)
    path.advance(Pose(1.9, 0.0))
    assert not check.is_reached(path, Pose(1.9, 0.0, 0.0))
    assert check.is_there
    assert check.is_reached(path, Pose(1.9, 0.0, 0.9))


def test_a_robot_that_stays_at_its_place_is_stuck() -> None:
    check = ProgressCheck(0.3, 5.0)
    assert not check.is_stuck(Pose(), 0.0)
    assert not check.is_stuck(Pose(0.4, 0.0), 4.0)
    assert not check.is_stuck(Pose(0.5, 0.0), 8.0)
    assert check.is_stuck(Pose(0.5, 0.0), 9.5)


def test_points_are_moved_to_the_frame_around_and_back() -> None:
    points, pose = np.array([[1.0, 2.0], [-3.0, 0.5]]), Pose(0.3, -1.0, 2.0)
    assert moved(moved(points, pose), pose.inverse()) == pytest.approx(points)
    assert tuple(pose @ pose.inverse()) == pytest.approx((0, 0, 0))
