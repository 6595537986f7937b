from __future__ import annotations

import math
from typing import Any

import pytest

from zbot.libraries.laser_projection import LaserProjection
from zbot.libraries.point_cloud import read_points

from sensor_msgs.msg import LaserScan

pytest.importorskip("numpy")
SCAN = LaserScan(
    angle_min=-math.pi / 2,
    angle_increment=math.pi / 2,
    range_min=0.5,
    range_max=10.0,
    time_increment=0.25,
    ranges=[2.0, 0.4, 3.0, 9.0, math.inf, math.nan],
    intensities=[10.0, 20.0, 30.0, 40.0, 50.0, 60.0],
)
Option = LaserProjection.ChannelOption


def test_valid_rays_become_points_in_the_frame_of_the_laser() -> None:
    SCAN.header.frame_id = "laser"
    cloud = LaserProjection().projectLaser(SCAN)
    points: Any = read_points(cloud)
    assert cloud.header.frame_id == "laser"
    assert points["x"].tolist() == pytest.approx([0.0, 0.0, -9.0], abs=1e-5)
    assert points["y"].tolist() == pytest.approx([-2.0, 3.0, 0.0], abs=1e-5)
    assert points["index"].tolist() == [0, 2, 3]


@pytest.mark.parametrize(
    ("options", "names"),
    [
        (Option.NONE, "x y z"),
        (Option.DEFAULT, "x y z intensity index"),
        (Option.DISTANCE | Option.TIMESTAMP, "x y z distances stamps"),
        (Option.VIEWPOINT, "x y z vp_x vp_y vp_z"),
    ],
)
def test_options_choose_the_fields(options: int, names: str) -> None:
    cloud = LaserProjection().projectLaser(SCAN, channel_options=options)
    assert " ".join(field.name for field in cloud.fields) == names


def test_far_points_are_cut_off() -> None:
    options = Option.DISTANCE | Option.TIMESTAMP
    points: Any = read_points(LaserProjection().projectLaser(SCAN, 3.0, options))
    assert (points["distances"].tolist(), points["stamps"].tolist()) == ([2.0], [0.0])
