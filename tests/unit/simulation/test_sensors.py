"""Tests of sensors against what geometry says."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.unit.simulation.conftest import drive, run, turned
from zbot.simulation.robots.equipment import Bumper, Camera, Imu, Lidar
from zbot.simulation.sensors.bumper import BumperSensor
from zbot.simulation.sensors.camera import CameraSensor
from zbot.simulation.sensors.imu import InertialSensor
from zbot.simulation.sensors.lidar import LidarScanner
from zbot.simulation.sensors.odometry import WheelOdometry
from zbot.simulation.world import World
from zbot.simulation.worlds.plan import Plan

if TYPE_CHECKING:
    from tests.unit.simulation.conftest import MakeWorld

EXACT = Lidar("base_scan", "scan", 10.0)


def box_distances(boxes: np.ndarray, origin: np.ndarray, rays: np.ndarray) -> np.ndarray:
    """Return the distances of rays to boxes. A box has its middle, half its size, and its yaw."""
    nearest = np.full(len(rays), np.inf)
    for x, y, half_x, half_y, yaw in boxes:
        cos, sin = math.cos(yaw), math.sin(yaw)
        back = np.array([[cos, sin], [-sin, cos]])
        start, way = back @ (origin - (x, y)), rays @ back.T
        with np.errstate(divide="ignore"):
            ends = (np.array([[-half_x, -half_y], [half_x, half_y]])[:, None] - start) / way
        enter, leave = ends.min(axis=0).max(axis=1), ends.max(axis=0).min(axis=1)
        hit = (enter <= leave) & (enter > 0)
        nearest[hit] = np.minimum(nearest[hit], enter[hit])
    return nearest


def circle_distances(circles: np.ndarray, origin: np.ndarray, rays: np.ndarray) -> np.ndarray:
    """Return the distances of rays to circles, which have a middle and a radius."""
    nearest = np.full(len(rays), np.inf)
    for x, y, radius in circles:
        away = origin - (x, y)
        along = rays @ away
        root = along**2 - (away @ away - radius**2)
        hit = (root >= 0) & (-along - np.sqrt(np.maximum(root, 0)) > 0)
        nearest[hit] = np.minimum(nearest[hit], (-along - np.sqrt(np.maximum(root, 0)))[hit])
    return nearest


def test_rays_are_within_a_millimetre_of_the_analytic_distances() -> None:
    random = np.random.default_rng(7)
    angles = np.linspace(0, 2 * math.pi, 360, endpoint=False)
    rays = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    for _ in range(30):
        plan = Plan()
        boxes = np.column_stack(
            [
                random.uniform(-8, 8, (12, 2)),
                random.uniform(0.1, 0.8, (12, 2)),
                random.uniform(-3, 3, 12),
            ]
        )
        for x, y, half_x, half_y, yaw in boxes:
            plan.box(x, y, (2 * half_x, 2 * half_y, 1.0), yaw=yaw)
        circles = np.column_stack([random.uniform(-8, 8, (8, 2)), random.uniform(0.05, 0.5, 8)])
        for x, y, radius in circles:
            plan.pillar(x, y, 2 * radius, 1.0)
        world = World(plan.spec())
        for origin in random.uniform(-6, 6, (10, 2)):
            inside = (np.hypot(*(circles[:, :2] - origin).T) < circles[:, 2]).any() or (
                np.hypot(*(boxes[:, :2] - origin).T) < 1.2
            ).any()
            if inside:
                continue
            found, _, _ = world.cast(
                np.array([*origin, 0.3]), np.column_stack([rays, np.zeros(360)])
            )
            expected = np.minimum(
                box_distances(boxes, origin, rays), circle_distances(circles, origin, rays)
            )
            found[found < 0] = np.inf
            # A ray along an edge may hit it or miss it.
            differs = ~np.isclose(found, expected, rtol=0, atol=1e-3)
            assert differs.sum() <= 1, (found[differs], expected[differs])


def test_a_lidar_begins_ahead_and_turns_to_the_left(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.room(-1.0, -2.0, 3.0, 4.0)
    world = make_world(plan, turned(0, 0, 0))
    found = LidarScanner(EXACT, world.robots["robot1"], 0).measure(world)
    assert found[[0, 90, 180, 270]] == pytest.approx([3.02, 4.0, 0.98, 2.0], abs=1e-3)


def test_a_lidar_turns_with_its_robot_and_sees_other_robots_but_not_itself(
    make_world: MakeWorld,
) -> None:
    world = make_world(None, turned(0, 0, math.pi / 2), turned(0, 1, 0))
    found = LidarScanner(EXACT, world.robots["robot1"], 0).measure(world)
    assert 0.8 < found[0] < 1.0
    assert np.isinf(found[90:270]).all()


def test_a_lidar_says_too_near_and_too_far_as_rep_117_does(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.box(0.5, 0.0, (0.1, 0.4, 1.0))
    world = make_world(plan, turned(0, 0, 0))
    near = replace(EXACT, nearest=1.0)
    assert LidarScanner(near, world.robots["robot1"], 0).measure(world)[[0, 90]].tolist() == [
        -math.inf,
        math.inf,
    ]
    short = replace(EXACT, farthest=0.3)
    assert LidarScanner(short, world.robots["robot1"], 0).measure(world)[0] == math.inf


def test_noise_depends_on_the_seed_and_the_time_only(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.room(-1.0, -1.0, 1.0, 1.0)
    noisy = replace(EXACT, noise=0.01)
    scans = []
    for seed, skipped in ((1, 0), (1, 3), (2, 0)):
        world = make_world(plan, turned(0, 0, 0), seed=seed)
        lidar = LidarScanner(noisy, world.robots["robot1"], 0)
        for _ in range(skipped):
            lidar.measure(world)
        run(world, 0.1)
        scans.append(lidar.measure(world))
    assert (scans[0] == scans[1]).all()
    assert (scans[0] != scans[2]).any()
    exact = LidarScanner(EXACT, world.robots["robot1"], 0).measure(world)
    assert 0.005 < float(np.std(scans[2] - exact)) < 0.015


def test_an_inertial_sensor_at_rest_measures_gravity(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 1.0))
    sensor = InertialSensor(Imu("imu_link", "imu", 100.0), world.robots["robot1"], 1)
    run(world, 0.5)
    sensor.measure(world)
    run(world, 0.012)
    reading = sensor.measure(world)
    assert reading.acceleration == pytest.approx([0.0, 0.0, 9.81], abs=0.02)
    assert reading.turn == pytest.approx([0, 0, 0], abs=1e-3)


def test_an_inertial_sensor_measures_turns_and_the_acceleration_of_a_curve(
    make_world: MakeWorld,
) -> None:
    world = make_world(None, turned(0, 0, 0))
    robot = world.robots["robot1"]
    sensor = InertialSensor(Imu("imu_link", "imu", 50.0), robot, 1)
    drive(world, robot, 0.4, 1.0, 2.0)
    sensor.measure(world)
    run(world, 0.02)
    reading = sensor.measure(world)
    assert reading.turn[2] == pytest.approx(1.0, abs=0.02)
    assert reading.acceleration[1] == pytest.approx(0.4, abs=0.06)


def test_a_bumper_names_what_it_touches(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.wall((0.5, -1.0), (0.5, 1.0))
    world = make_world(plan, turned(0, 0, 0))
    robot = world.robots["robot1"]
    bumper = BumperSensor(Bumper("base_link", "bumper", 20.0), robot)
    assert bumper.measure(world) == []
    drive(world, robot, 0.3, 0.0, 3.0)
    touches = [touch for touch in bumper.measure(world) if touch.other == "wall"]
    assert touches
    assert touches[0].normal[0] == pytest.approx(-1.0, abs=0.01)
    assert touches[0].point[0] == pytest.approx(0.45, abs=0.01)


def test_a_camera_measures_depth_along_its_direction(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.wall((2.0, -5.0), (2.0, 5.0), height=4.0)
    world = make_world(plan, turned(0, 0, 0))
    camera = CameraSensor(Camera("camera_link", "camera", 10.0), world.robots["robot1"], 0)
    picture = camera.measure(world)
    assert picture.color.shape == (120, 160, 3)
    upper = picture.depth[:50]
    assert upper == pytest.approx(np.full_like(upper, 1.95 - 0.075), abs=5e-3)
    assert (picture.depth[110] < 1.0).all(), "the floor is nearer at the lower edge"


def test_a_camera_shows_the_colours_of_things_and_the_sky(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.box(1.0, 0.0, (0.2, 0.6, 0.3))
    world = make_world(plan, turned(0, 0, 0))
    camera = CameraSensor(Camera("camera_link", "camera", 10.0), world.robots["robot1"], 0)
    color = camera.measure(world).color.astype(int)
    assert color[0, 0].tolist() == [170, 210, 250]
    red, _, blue = color[60, 80]
    assert red > 1.5 * blue, "wood is brown"


def test_odometry_follows_the_wheels(make_world: MakeWorld) -> None:
    world = make_world(None, turned(1, 1, 1.0))
    robot = world.robots["robot1"]
    odometry = WheelOdometry(robot)
    odometry.measure(world)
    robot.command = (0.3, 0.0, 0.6)
    for _ in range(50):
        run(world, 0.04)
        odometry.measure(world)
    way = turned(1, 1, 1.0).inverse() @ robot.pose
    assert odometry.pose.translation[:2] == pytest.approx(way.translation[:2], abs=0.02)
    assert odometry.speed == pytest.approx((0.3, 0.0, 0.6), abs=0.02)


def test_the_points_of_a_camera_are_where_its_rays_end(make_world: MakeWorld) -> None:
    plan = Plan()
    plan.wall((2.0, -5.0), (2.0, 5.0), height=4.0)
    world = make_world(plan, turned(0, 0, 0))
    robot = world.robots["robot1"]
    spec = Camera("camera_link", "camera", 10.0)
    camera = CameraSensor(spec, robot, 0)
    picture = camera.measure(world)
    points = camera.points(picture)
    to_wall = 1.95 - robot.link_pose("camera_link").translation[0]
    assert points[30, 80, 0] == pytest.approx(to_wall, abs=1e-3)
    assert points[30, 0, 1] > 0 > points[30, -1, 1], "y is to the left"
    assert points[50, 80, 2] > 0 > points[70, 80, 2], "z is up"
    optical = CameraSensor(replace(spec, has_optical_points=True), robot, 0).points(picture)
    x, y, z = np.moveaxis(points, 2, 0)
    np.testing.assert_allclose(optical, np.stack([-y, -z, x], axis=2))
