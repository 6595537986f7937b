"""Tests of the map that grows with scans, of the scan matcher and of the particle filter."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.unit.nodes.navigation.house import GEOMETRY, look, occupied
from zbot_nodes.navigation.grids.occupancy_map import OccupancyMap
from zbot_nodes.navigation.grids.particle_filter import (
    LikelihoodField,
    MotionNoise,
    ParticleFilter,
)
from zbot_nodes.navigation.grids.rays import Rays
from zbot_nodes.navigation.grids.scan_matcher import ScanMatcher
from zbot_nodes.robot.pose import Pose, turn_to

START = Pose(-1.5, -0.5, 0.3)


def away(found: Pose, true: Pose) -> tuple[float, float]:
    """Return how far two poses are from each other: metres and radians."""
    return math.hypot(found.x - true.x, found.y - true.y), abs(turn_to(found.yaw - true.yaw))


def test_a_map_knows_what_is_free_what_is_occupied_and_what_nobody_saw() -> None:
    built = OccupancyMap(0.1)
    for _ in range(3):
        ends = np.array([[2.05, 0.05], [0.05, 3.05]])
        built.add(Rays(np.array([0.05, 0.05]), ends, np.array([True, False])))
    cells, geometry = built.cells(), built.geometry
    assert cells[geometry.cell(2.05, 0.05)] == 100
    assert cells[geometry.cell(1.0, 0.05)] == 0
    assert cells[geometry.cell(0.05, 2.5)] == 0
    assert cells[geometry.cell(1.0, 1.0)] == -1


def test_a_map_grows_and_keeps_what_it_has() -> None:
    built = OccupancyMap(0.1)
    built.add(Rays(np.zeros(2), np.array([[1.05, 0.05]]), np.array([True])))
    built.add(Rays(np.zeros(2), np.array([[-9.05, -7.05]]), np.array([True])))
    cells, geometry = built.cells(), built.geometry
    assert geometry.x < -9
    assert cells[geometry.cell(1.05, 0.05)] == cells[geometry.cell(-9.05, -7.05)] == 100


def test_a_thing_that_has_gone_disappears_from_the_map() -> None:
    built = OccupancyMap(0.1)
    built.add(Rays(np.zeros(2), np.array([[1.05, 0.05]]), np.array([True])))
    for _ in range(5):
        built.add(Rays(np.zeros(2), np.array([[2.05, 0.1]]), np.array([True])))
    assert built.cells()[built.geometry.cell(1.05, 0.05)] == 0


@pytest.mark.parametrize("error", [Pose(), Pose(0.15, -0.1, 0.12), Pose(-0.12, 0.16, -0.15)])
def test_a_scan_is_matched_with_the_map(error: Pose) -> None:
    matcher = ScanMatcher(occupied(), GEOMETRY)
    for true in (START, Pose(1.8, -0.6, 2.5)):
        guess = Pose(true.x + error.x, true.y + error.y, true.yaw + error.yaw)
        found = matcher.match(look(true).hits, guess)
        way, turn = away(found.pose, true)
        assert way < 0.04
        assert turn < 0.02
        assert found.error_m < 0.04


def test_a_scan_of_another_place_does_not_match() -> None:
    points = np.random.default_rng(3).uniform(-2, 2, (100, 2))
    assert ScanMatcher(occupied(), GEOMETRY).match(points, START).error_m > 0.15


def test_a_scan_without_points_leaves_the_guess() -> None:
    assert ScanMatcher(occupied(), GEOMETRY).match(np.zeros((0, 2)), START).pose == START


def test_a_walk_makes_a_map_although_the_odometry_drifts() -> None:
    built, pose, odom, correction = OccupancyMap(0.05), START, Pose(), START
    found = START
    for number in range(60):
        if number:
            step = Pose(0.06, 0.0, 0.05 * math.sin(number / 5))
            pose = pose @ step
            odom = odom @ Pose(step.x * 1.03, 0.002, step.yaw + 0.004)
        rays = look(pose, seed=number)
        found = correction @ odom
        if number:
            found = ScanMatcher(built.occupied, built.geometry).match(rays.hits, found).pose
        correction = found @ odom.inverse()
        built.add(rays.seen_from(found))
    way, turn = away(found, pose)
    assert way < 0.08
    assert turn < 0.03
    assert away(START @ odom, pose)[0] > 0.2


def drive(particles: ParticleFilter, pose: Pose, steps: int) -> Pose:
    """Drive around the box, and let the filter see what the lidar sees."""
    field = LikelihoodField(occupied(), GEOMETRY)
    noise = MotionNoise()
    for number in range(steps):
        step = Pose(0.1, 0.0, 0.12 * math.sin(number / 3))
        pose = pose @ step
        particles.move(Pose(step.x * 1.05, 0.0, step.yaw + 0.01), noise)
        particles.weigh(field, look(pose, seed=number).hits[::4])
        particles.resample(200, 2000)
    return pose


def test_particles_follow_a_robot_that_starts_at_a_known_place() -> None:
    particles = ParticleFilter(seed=1)
    particles.spread_around(START, np.diag([0.1, 0.1, 0.05]), 1000)
    pose = drive(particles, START, 20)
    way, turn = away(particles.estimate().pose, pose)
    assert way < 0.1
    assert turn < 0.05
    assert np.sqrt(np.diag(particles.estimate().covariance)).max() < 0.1


def test_particles_find_a_robot_in_the_whole_map() -> None:
    particles = ParticleFilter(seed=1)
    inside = GEOMETRY.centres(*np.mgrid[12:68, 12:108].reshape(2, -1))
    particles.spread_over(inside, 5000)
    pose = drive(particles, START, 20)
    way, turn = away(particles.estimate().pose, pose)
    assert way < 0.15
    assert turn < 0.1
    assert len(particles.poses) < 1000
