"""Tests of the conversion between point clouds and arrays."""

from __future__ import annotations

import math
from typing import Any

import pytest

from zbot.libraries.point_cloud import (
    PointCloudError,
    create_cloud,
    create_cloud_xyz32,
    dtype_from_fields,
    read_points,
    read_points_list,
    read_points_numpy,
)

from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Header

np = pytest.importorskip("numpy")
HEADER = Header(frame_id="lidar")
POINTS = [(0.0, 0.5, 1.0), (2.0, math.nan, 3.0), (4.0, 4.5, 5.0), (6.0, 6.5, 7.0)]


def field(name: str, offset: int, datatype: int = PointField.FLOAT32, count: int = 1) -> PointField:
    return PointField(name=name, offset=offset, datatype=datatype, count=count)


XYZ = [field("x", 0), field("y", 4), field("z", 8)]
MIXED = [field("x", 0), field("t", 4, PointField.FLOAT64), field("ring", 12, PointField.UINT8)]


def test_a_cloud_of_lists_is_read_back() -> None:
    cloud = create_cloud_xyz32(HEADER, POINTS)
    assert (cloud.header, cloud.width, cloud.height) == (HEADER, 4, 1)
    assert (cloud.point_step, cloud.row_step, len(cloud.data)) == (12, 48, 48)
    assert not cloud.is_dense
    assert cloud.fields == XYZ
    points = read_points(cloud)
    assert points.dtype.names == ("x", "y", "z")
    assert points["z"].tolist() == [1.0, 3.0, 5.0, 7.0]
    assert read_points_list(cloud, ["x", "z"])[2] == (4.0, 5.0)
    assert read_points_list(cloud)[2].y == 4.5


def test_points_are_chosen_by_field_value_and_index() -> None:
    cloud = create_cloud_xyz32(HEADER, np.array(POINTS, np.float32))
    assert read_points_numpy(cloud, skip_nans=True).shape == (3, 3)
    assert read_points_numpy(cloud, ["x", "z"], skip_nans=True).shape == (4, 2)
    assert read_points(cloud, uvs=[3, 0])["x"].tolist() == [6.0, 0.0]
    cloud.is_dense = True  # states that every point is valid
    assert len(read_points(cloud, skip_nans=True)) == 4


def test_rows_of_a_cloud_are_kept_on_request() -> None:
    cloud = create_cloud_xyz32(HEADER, np.zeros((2, 3, 3), np.float32))
    assert (cloud.width, cloud.height) == (2, 3)
    assert read_points(cloud).shape == (6,)
    assert read_points_numpy(cloud, reshape_organized_cloud=True).shape == (3, 2, 3)


def test_padding_after_points_and_rows_is_skipped() -> None:
    rows = np.full((2, 40), 9, np.uint8)
    rows[:, :32].view(np.float32)[:] = [[1, 2, 3, 0, 4, 5, 6, 0]] * 2
    cloud = PointCloud2(
        height=2, width=2, fields=XYZ, point_step=16, row_step=40, data=rows.tobytes()
    )
    assert read_points_numpy(cloud).tolist() == [[1, 2, 3], [4, 5, 6]] * 2


@pytest.mark.parametrize("is_bigendian", [False, True])
def test_the_byte_order_is_that_of_the_cloud(is_bigendian: bool) -> None:
    data = np.array([1.5, 2.5, 3.5], ">f4" if is_bigendian else "<f4").tobytes()
    cloud = PointCloud2(
        height=1,
        width=1,
        fields=XYZ,
        is_bigendian=is_bigendian,
        point_step=12,
        row_step=12,
        data=data,
    )
    assert read_points_numpy(cloud).tolist() == [[1.5, 2.5, 3.5]]
    assert read_points(cloud).dtype.isnative


def test_fields_of_different_types_need_a_structured_array() -> None:
    points = np.array([(1.5, 2.5, 3)], dtype_from_fields(MIXED))
    cloud = create_cloud(HEADER, MIXED, points)
    assert read_points(cloud).tolist() == [(1.5, 2.5, 3)]
    assert create_cloud(HEADER, MIXED, [(1.5, 2.5, 3)]) == cloud
    assert read_points_numpy(cloud, ["x"]).tolist() == [[1.5]]
    with pytest.raises(PointCloudError, match="read_points"):
        read_points_numpy(cloud)


def test_a_field_with_several_values_becomes_several_columns() -> None:
    cloud = create_cloud(HEADER, [field("v", 0, count=3)], np.array(POINTS, np.float32))
    assert read_points(cloud).dtype.names == ("v_0", "v_1", "v_2")
    assert dtype_from_fields([field("", 0), field("", 4)]).names == (
        "unnamed_field_0",
        "unnamed_field_1",
    )


def test_a_wider_step_is_kept_and_a_wrong_step_is_refused() -> None:
    wide = np.array(POINTS, dtype_from_fields(XYZ, 20))
    assert create_cloud(HEADER, XYZ, wide).point_step == 20
    assert create_cloud(HEADER, XYZ, POINTS, 20).point_step == 20
    with pytest.raises(PointCloudError, match="fields say"):
        create_cloud(HEADER, XYZ, wide, 12)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"fields": [field("x", 0), field("x", 4)]}, "the same name"),
        ({"fields": [field("x", 0, 99)]}, "unknown type 99"),
        ({"fields": [PointField(name="x", datatype=7, count=2**32 - 1)]}, "more than 10000 values"),
        ({"data": b"short"}, "needs 48 bytes, but it has 5"),
    ],
)
def test_inconsistent_clouds_are_refused(changes: dict[str, Any], sentence: str) -> None:
    cloud = create_cloud_xyz32(HEADER, POINTS)
    for name, value in changes.items():
        setattr(cloud, name, value)
    with pytest.raises(AssertionError, match=sentence):
        read_points(cloud)
    with pytest.raises(PointCloudError, match="no field 'w'"):
        read_points(create_cloud_xyz32(HEADER, POINTS), ["w"])


def test_an_empty_cloud_has_no_points() -> None:
    assert len(read_points(create_cloud_xyz32(HEADER, []))) == 0
