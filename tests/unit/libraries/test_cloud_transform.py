"""Tests of point clouds in another frame; their other fields are kept."""

from __future__ import annotations

import math

import pytest

from zbot.libraries.cloud_transform import do_transform_cloud, transform_points
from zbot.libraries.point_cloud import PointCloudError, create_cloud, read_points
from zbot.tf2 import Buffer

from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Header

np = pytest.importorskip("numpy")

HALF = math.sqrt(0.5)
#: A lidar a metre above the base, looking to its left.
MOUNTED = TransformStamped(
    header=Header(frame_id="base"),
    child_frame_id="lidar",
    transform=Transform(translation=Vector3(x=0.5, z=1.0), rotation=Quaternion(z=HALF, w=HALF)),
)
FIELDS = [
    PointField(name=name, offset=offset, datatype=datatype, count=1)
    for name, offset, datatype in [
        ("x", 0, PointField.FLOAT32),
        ("y", 4, PointField.FLOAT32),
        ("z", 8, PointField.FLOAT32),
        ("ring", 14, PointField.UINT16),
    ]
]


def cloud() -> PointCloud2:
    points = [(1.0, 0.0, 0.0, 7), (0.0, 2.0, 0.5, 8)]
    return create_cloud(Header(frame_id="lidar"), FIELDS, points, 20)


def test_points_are_transformed_and_other_fields_are_kept() -> None:
    before = cloud()
    moved = do_transform_cloud(before, MOUNTED)
    points = read_points(moved)
    assert points["x"].tolist() == pytest.approx([0.5, -1.5])
    assert points["y"].tolist() == pytest.approx([1.0, 0.0], abs=1e-6)
    assert points["z"].tolist() == pytest.approx([1.0, 1.5])
    assert points["ring"].tolist() == [7, 8]
    assert (moved.header.frame_id, moved.width, moved.height) == ("base", 2, 1)
    assert (moved.point_step, len(moved.data)) == (20, 40)
    assert before == cloud()


def test_rows_are_kept_and_a_plain_transform_keeps_the_header() -> None:
    before = cloud()
    before.width, before.height, before.row_step = 1, 2, 20
    moved = do_transform_cloud(before, MOUNTED.transform)
    assert (moved.width, moved.height, moved.row_step) == (1, 2, 20)
    assert moved.header.frame_id == "lidar"


def test_a_buffer_transforms_a_cloud() -> None:
    buffer = Buffer()
    buffer.set_transform_static(MOUNTED, "test")
    assert buffer.transform(cloud(), "base") == do_transform_cloud(cloud(), MOUNTED)


def test_an_array_is_transformed_at_any_length_of_the_quaternion() -> None:
    turned = transform_points([[1, 0, 0]], Transform(rotation=Quaternion(z=3.0, w=3.0)))
    assert turned.tolist() == [pytest.approx([0.0, 1.0, 0.0])]
    none = Transform(rotation=Quaternion(w=0.0))
    assert transform_points([[1, 2, 3]], none).tolist() == [[1, 2, 3]]


def test_a_cloud_without_z_is_refused() -> None:
    flat = create_cloud(Header(), FIELDS[:2], [(1.0, 2.0)])
    with pytest.raises(PointCloudError, match="'z'"):
        do_transform_cloud(flat, MOUNTED)
