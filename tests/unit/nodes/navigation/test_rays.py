"""Tests of rays, of their cells in a grid, and of distances to occupied cells."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from zbot.tf2.rigid import Rigid
from zbot_nodes.navigation.grids.distances import distances
from zbot_nodes.navigation.grids.geometry import (
    GridGeometry,
    cells_of,
    geometry_of,
    grid_message,
    is_whole,
)
from zbot_nodes.navigation.grids.rays import Rays, crossed, marked, rays_of
from zbot_nodes.robot.pose import Pose

from builtin_interfaces.msg import Time  # isort: skip

GRID = GridGeometry(-1.0, -1.0, 0.1, 20, 40)


def scan(*ranges: float) -> SimpleNamespace:
    """Return a scan with rays to the front, the left, the back and the right."""
    return SimpleNamespace(
        ranges=ranges, angle_min=0.0, angle_increment=math.pi / 2, range_min=0.1, range_max=5.0
    )


def test_rays_end_where_the_lidar_measured_in_the_frame_of_the_robot() -> None:
    rays = rays_of(scan(1.0, 2.0, 3.0, 0.5), Rigid((0.1, 0.0, 0.2)))
    assert rays.hits == pytest.approx(np.array([(1.1, 0), (0.1, 2), (-2.9, 0), (0.1, -0.5)]))
    assert rays.origin == pytest.approx((0.1, 0.0))


def test_a_lidar_that_hangs_upside_down_sees_left_as_right() -> None:
    rays = rays_of(scan(1.0, 2.0, 3.0, 0.5), Rigid(rotation=(1.0, 0.0, 0.0, 0.0)))
    assert rays.hits == pytest.approx(np.array([(1, 0), (0, -2), (-3, 0), (0, 0.5)]))


def test_a_ray_without_an_echo_is_free_and_one_without_a_meaning_is_left_out() -> None:
    rays = rays_of(scan(math.inf, math.nan, 0.0, 1.0), Rigid())
    assert rays.is_hit.tolist() == [False, True]
    assert rays.ends == pytest.approx(np.array([(5, 0), (0, -1)]))


def test_a_ray_crosses_all_cells_before_its_end() -> None:
    rays = Rays(np.array([0.05, 0.05]), np.array([[1.05, 0.05]]), np.array([True]))
    cells = crossed(rays, GRID)
    assert np.flatnonzero(cells[10]).tolist() == list(range(10, 20))
    assert cells.sum() == 10
    assert np.argwhere(marked(rays.hits, GRID)).tolist() == [[10, 20]]


def test_points_outside_of_the_grid_are_left_out() -> None:
    rays = Rays(np.array([0.0, 0.0]), np.array([[50.0, 0.05]]), np.array([True]))
    assert crossed(rays, GRID)[10, 10:].all()
    assert not marked(rays.hits, GRID).any()


def test_rays_are_cut_at_a_distance() -> None:
    rays = Rays(np.zeros(2), np.array([[1.0, 0.0], [0.0, 3.0]]), np.array([True, True])).up_to(2.0)
    assert rays.ends == pytest.approx(np.array([(1, 0), (0, 2)]))
    assert rays.is_hit.tolist() == [True, False]


def test_a_scan_with_senseless_numbers_has_few_rays() -> None:
    odd = scan(1.0, math.inf)
    odd.range_max, odd.angle_increment = math.inf, math.nan
    assert not len(rays_of(odd, Rigid()).ends)


def test_a_grid_that_has_not_all_cells_is_noticed() -> None:
    message = grid_message(np.zeros((2, 3)), GridGeometry(0.0, 0.0, 0.5, 2, 3), "map", Time())
    assert is_whole(message)
    message.info.width = 4_000_000_000
    assert not is_whole(message)


def test_rays_are_moved_to_the_frame_of_a_pose() -> None:
    rays = Rays(np.zeros(2), np.array([[1.0, 0.0]]), np.array([True]))
    assert rays.seen_from(Pose(1.0, 2.0, math.pi / 2)).hits == pytest.approx(np.array([(1, 3)]))


def test_distances_are_those_of_a_search_through_all_cells() -> None:
    occupied = np.random.default_rng(1).random((17, 23)) < 0.02
    rows, columns = np.mgrid[0:17, 0:23]
    away = [np.hypot(rows - row, columns - column) for row, column in np.argwhere(occupied)]
    expected = np.minimum(np.min(away, axis=0), 6)
    assert distances(occupied, 6) == pytest.approx(expected, abs=1e-5)


def test_a_grid_without_obstacles_has_the_greatest_distance_everywhere() -> None:
    assert (distances(np.zeros((3, 4), bool), 5) == 5).all()


def test_a_grid_survives_the_way_through_a_message() -> None:
    cells = np.arange(12, dtype=np.int8).reshape(3, 4)
    geometry = GridGeometry(1.0, -2.0, 0.5, 3, 4)
    message = grid_message(cells, geometry, "map", Time(sec=3))
    assert cells_of(message).tolist() == cells.tolist()
    assert geometry_of(message.info) == geometry
    assert (message.header.frame_id, message.header.stamp.sec) == ("map", 3)
