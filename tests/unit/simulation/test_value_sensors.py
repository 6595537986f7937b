"""Tests of sonars, satellite receivers, batteries and lidars with rows."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.unit.simulation.conftest import drive, run, tags_of, turned
from zbot.simulation.robots.catalog import find_robot
from zbot.simulation.robots.equipment import Battery, CloudLidar, Gps, Sonar
from zbot.simulation.sensors.battery import BatteryMeter
from zbot.simulation.sensors.cloud import CloudScanner
from zbot.simulation.sensors.gps import Fix, GpsReceiver, place_on_earth
from zbot.simulation.sensors.sonar import SonarSensor
from zbot.simulation.worlds.plan import Plan

if TYPE_CHECKING:
    from tests.unit.simulation.conftest import MakeWorld

SONAR = Sonar("base_scan", "sonar", 20.0)
GPS = Gps("base_link", "fix", 5.0, origin=(52.0, 13.0, 30.0))


def plan_with_wall(distance: float) -> Plan:
    """Return a world with a wall whose near side is this far ahead of the origin."""
    plan = Plan()
    plan.wall((distance + 0.05, -2.0), (distance + 0.05, 2.0))
    return plan


def test_a_sonar_measures_the_nearest_thing_in_its_cone(make_world: MakeWorld) -> None:
    world = make_world(plan_with_wall(2.0), turned(0, 0, 0))
    robot = world.robots["robot1"]
    ahead = robot.link_pose("base_scan").translation[0]
    assert SonarSensor(SONAR, robot, 0).measure(world) == pytest.approx(2.0 - ahead, abs=1e-3)
    plan = plan_with_wall(2.0)
    plan.pillar(1.0, 0.15, 0.1)  # aside of the axis, but in the cone
    world = make_world(plan, turned(0, 0, 0))
    assert SonarSensor(SONAR, world.robots["robot1"], 0).measure(world) < 1.1


def test_a_sonar_says_too_near_and_too_far_as_rep_117_does(make_world: MakeWorld) -> None:
    world = make_world(plan_with_wall(1.0), turned(0, 0, 0))
    robot = world.robots["robot1"]
    assert SonarSensor(replace(SONAR, farthest=0.5), robot, 0).measure(world) == math.inf
    assert SonarSensor(replace(SONAR, nearest=2.0), robot, 0).measure(world) == -math.inf


def test_a_degree_to_the_north_is_111_km_and_one_to_the_east_is_less() -> None:
    north = place_on_earth(Fix(52.0, 13.0, 0.0), 0.0, 1112.7, 0.0)
    east = place_on_earth(Fix(52.0, 13.0, 0.0), 686.8, 0.0, 5.0)
    assert north.latitude == pytest.approx(52.01, abs=1e-5)
    assert east.longitude == pytest.approx(13.01, abs=1e-5)
    assert east.altitude == 5.0


def test_a_receiver_is_as_exact_as_its_noise(make_world: MakeWorld) -> None:
    world = make_world(None, turned(3, 4, 0))
    receiver = GpsReceiver(replace(GPS, noise=0.5), world.robots["robot1"], 0)
    fixes = []
    for _ in range(300):
        world.steps += 1
        fixes.append(receiver.measure(world).latitude)
    metre = place_on_earth(Fix(52.0, 13.0, 30.0), 0.0, 1.0, 0.0).latitude - 52.0
    assert np.mean(fixes) == pytest.approx(52.0 + 4 * metre, abs=0.12 * metre)
    assert np.std(fixes) == pytest.approx(0.5 * metre, rel=0.15)


def test_driving_uses_up_the_battery(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0))
    robot = world.robots["robot1"]
    spec = Battery("base_link", "battery_state", 1.0, capacity=1.0, idle_current=0.36)
    meter = BatteryMeter(spec, robot, 0)
    run(world, 10.0)
    resting = meter.measure(world)
    assert resting.charge == pytest.approx(1 - 0.36 * 10 / 3600, rel=1e-4)
    drive(world, robot, 0.5, 0.0, 10.0)
    driving = meter.measure(world)
    assert driving.current == pytest.approx(-(0.36 + 3.0 * 0.5), rel=0.05)
    assert driving.charge < resting.charge < spec.capacity
    assert driving.voltage < resting.voltage < spec.voltage


def test_a_battery_is_full_again_after_a_reset(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0))
    meter = BatteryMeter(Battery("base_link", "battery_state", 1.0), world.robots["robot1"], 0)
    run(world, 5.0)
    meter.measure(world)
    world.reset()
    world.steps = 0
    assert meter.measure(world).share == 1.0


def test_a_lidar_with_rows_measures_points_on_the_floor_and_the_wall(make_world: MakeWorld) -> None:
    world = make_world(plan_with_wall(2.0), turned(0, 0, 0))
    robot = world.robots["robot1"]
    spec = CloudLidar(
        *("base_scan", "points", 10.0),
        rays=3,
        first_angle=-0.1,
        last_angle=0.1,
        rows=3,
        lowest_angle=-0.3,
        highest_angle=0.0,
    )
    points = CloudScanner(spec, robot, 0).measure(world).reshape(3, 3, 3)
    height = robot.link_pose("base_scan").translation[2]
    assert points[0, :, 2] == pytest.approx(-height, abs=1e-3), "the lowest row sees the floor"
    ahead = robot.link_pose("base_scan").translation[0]
    assert points[2, :, 0] == pytest.approx(2.0 - ahead, abs=1e-3), "the highest row sees the wall"


def test_points_out_of_reach_are_not_numbers(make_world: MakeWorld) -> None:
    world = make_world(None, turned(0, 0, 0))
    spec = CloudLidar("base_scan", "points", 10.0, rays=8, rows=2, lowest_angle=0.1)
    points = CloudScanner(spec, world.robots["robot1"], 0).measure(world)
    assert np.isnan(points).all()


def test_gazebo_tags_name_these_sensors() -> None:
    found = tags_of(
        "<robot name='r'><gazebo reference='base'>"
        "<sensor type='sonar'><sonar><min>0.1</min><max>2</max><radius>0.5</radius></sonar>"
        "</sensor>"
        "<sensor type='navsat'><topic>fix</topic><navsat><position_sensing><horizontal><noise>"
        "<stddev>0.3</stddev></noise></horizontal></position_sensing></navsat></sensor>"
        "<sensor type='battery'><battery><capacity>5</capacity></battery></sensor>"
        "<sensor type='gpu_lidar'><lidar><scan><horizontal><samples>90</samples></horizontal>"
        "<vertical><samples>4</samples><min_angle>-0.1</min_angle><max_angle>0.2</max_angle>"
        "</vertical></scan></lidar></sensor></gazebo></robot>"
    )
    sonar, gps, battery, lidar = found.sensors
    assert isinstance(sonar, Sonar)
    assert (sonar.nearest, sonar.farthest) == (0.1, 2.0)
    assert sonar.field_of_view == pytest.approx(2 * math.atan(0.25))
    assert isinstance(gps, Gps)
    assert (gps.topic, gps.noise) == ("fix", 0.3)
    assert isinstance(battery, Battery)
    assert battery.capacity == 5.0
    assert isinstance(lidar, CloudLidar)
    assert (lidar.rays, lidar.rows, lidar.lowest_angle, lidar.highest_angle) == (90, 4, -0.1, 0.2)


@pytest.mark.parametrize("value", ["1e308", "-5", "0", "nan", "inf"])
def test_hostile_numbers_give_a_sensor_or_one_sentence(value: str) -> None:
    from zbot.errors import ZbotError  # noqa: PLC0415 - for this test only

    text = (
        "<robot name='r'><gazebo reference='b'>"
        f"<sensor type='sonar'><sonar><max>{value}</max><radius>{value}</radius></sonar></sensor>"
        f"<sensor type='gps'><origin><latitude>{value}</latitude></origin></sensor>"
        f"<sensor type='battery'><battery><capacity>{value}</capacity></battery></sensor>"
        f"<sensor type='lidar'><lidar><scan><vertical><samples>{value}</samples></vertical></scan>"
        "</lidar></sensor></gazebo></robot>"
    )
    try:
        sensors = tags_of(text).sensors
    except ZbotError:
        return
    assert len(sensors) == 4


def test_the_four_wheeled_robot_has_all_sensors() -> None:
    kinds = {type(sensor).__name__ for sensor in find_robot("four_wheeled").equipment.sensors}
    assert kinds == {"Lidar", "CloudLidar", "Imu", "Bumper", "Camera", "Sonar", "Gps", "Battery"}
