"""Tests of poses with covariance, wrenches and polygons in other frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from zbot.libraries.cloud_transform import do_transform_cloud
from zbot.tf2 import TransformRegistration
from zbot.tf2 import transformations as tf
from zbot.tf2.conversion import (
    do_transform_point,
    do_transform_polygon_stamped,
    do_transform_pose,
    do_transform_pose_stamped,
    do_transform_pose_with_covariance_stamped,
    do_transform_vector3,
    do_transform_wrench,
)

from geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    Quaternion,
    Transform,
    TransformStamped,
    Vector3,
    WrenchStamped,
)
from sensor_msgs.msg import LaserScan, PointCloud2

if TYPE_CHECKING:
    from collections.abc import Callable

ANGLES = (0.3, -0.4, 0.5)


def moved(*, angles: tuple[float, float, float] = ANGLES) -> TransformStamped:
    transform = TransformStamped()
    transform.header.frame_id = "map"
    transform.transform.translation = Vector3(x=1.0, y=2.0, z=3.0)
    q = transform.transform.rotation
    q.x, q.y, q.z, q.w = map(float, tf.quaternion_from_euler(*angles))
    return transform


def test_covariance_is_rotated_from_both_sides() -> None:
    covariance = np.arange(36.0)
    pose = PoseWithCovarianceStamped()
    pose.pose.covariance = covariance
    found = do_transform_pose_with_covariance_stamped(pose, moved())
    rotation = np.kron(np.identity(2), tf.euler_matrix(*ANGLES)[:3, :3])
    expected = rotation @ covariance.reshape(6, 6) @ rotation.T
    assert np.allclose(found.pose.covariance, expected.ravel())
    assert (found.header.frame_id, found.pose.pose.position.y) == ("map", 2.0)
    assert pose.pose.covariance[1] == 1.0


def test_covariance_is_unchanged_by_a_translation() -> None:
    pose = PoseWithCovarianceStamped()
    pose.pose.covariance = np.arange(36.0)
    found = do_transform_pose_with_covariance_stamped(pose, moved(angles=(0.0, 0.0, 0.0)))
    assert np.allclose(found.pose.covariance, np.arange(36.0))


def test_a_wrench_is_rotated_but_not_moved() -> None:
    wrench = WrenchStamped()
    wrench.wrench.force.x, wrench.wrench.torque.y = 1.0, 2.0
    found = do_transform_wrench(wrench, moved(angles=(0.0, 0.0, np.pi / 2)))
    assert (found.wrench.force.x, found.wrench.force.y) == pytest.approx((0, 1))
    assert (found.wrench.torque.x, found.wrench.torque.y) == pytest.approx((-2, 0))


def test_a_polygon_is_moved_and_rotated() -> None:
    polygon = PolygonStamped()
    polygon.polygon.points = [Point32(x=1.0), Point32(y=1.0)]
    found = do_transform_polygon_stamped(polygon, moved(angles=(0.0, 0.0, np.pi / 2)))
    assert [(p.x, p.y, p.z) for p in found.polygon.points] == [
        pytest.approx((1, 3, 3), abs=1e-6),
        pytest.approx((0, 2, 3), abs=1e-6),
    ]


def _quaternion(x: float, y: float, z: float, w: float) -> Quaternion:
    return Quaternion(x=x, y=y, z=z, w=w)


def _parts(q: Quaternion) -> tuple[float, ...]:
    return (q.x, q.y, q.z, q.w)


@pytest.mark.parametrize(
    ("orientation", "rotation", "expected"),
    [
        ((0.0, 0.0, 0.8, 0.6), (0.0, 0.0, 0.8, 0.6), (0.0, 0.0, -0.96, 0.28)),
        ((0.0, 0.0, 0.0, -1.0), (0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 1.0)),
        ((0.0, 0.0, 0.0, 2.0), (0.0, 0.0, 1.2, 1.6), (0.0, 0.0, 0.6, 0.8)),
        ((0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.6, 0.8), (0.0, 0.0, 0.6, 0.8)),
    ],
    ids=["more than half a turn", "negative", "not of length 1", "zero"],
)
def test_an_orientation_has_the_normal_form(
    orientation: tuple[float, ...], rotation: tuple[float, ...], expected: tuple[float, ...]
) -> None:
    transform = TransformStamped()
    transform.transform.rotation = _quaternion(*rotation)
    pose = Pose(orientation=_quaternion(*orientation))
    assert _parts(do_transform_pose(pose, transform).orientation) == pytest.approx(expected)


@pytest.mark.parametrize(
    ("function", "value", "sentence"),
    [
        (do_transform_pose, PoseStamped(), r"a Pose, not PoseStamped.*_pose_stamped\(\)"),
        (do_transform_pose_stamped, Pose(), r"a PoseStamped, not Pose: write do_transform_pose\("),
        (do_transform_pose_stamped, PoseWithCovarianceStamped(), r"pose_with_covariance_stamped\("),
        (do_transform_pose_with_covariance_stamped, PoseStamped(), r"_pose_stamped\(\)"),
        (do_transform_point, Point(), r"a PointStamped, not Point: write PointStamped\(point="),
        (do_transform_point, PointStamped, "not the class PointStamped"),
        (do_transform_vector3, PointCloud2(), r"do_transform_cloud\(\)"),
        (do_transform_wrench, None, "a WrenchStamped, not None"),
        (do_transform_polygon_stamped, TransformStamped(), r"\(polygon_stamped, transform\), in"),
        (do_transform_cloud, LaserScan(), "a PointCloud2, not LaserScan"),
    ],
)
def test_the_object_of_another_function_is_refused(
    function: Callable[[Any, Any], Any], value: Any, sentence: str
) -> None:
    with pytest.raises(AttributeError, match=f"{function.__name__} needs .*{sentence}"):
        function(value, moved())


def test_what_is_not_a_transform_is_refused() -> None:
    for transform in (None, Transform(), TransformStamped):
        with pytest.raises(AttributeError, match=r"needs a TransformStamped, not .*lookup_tra"):
            do_transform_point(PointStamped(), transform)
    assert do_transform_pose(Pose(), moved().transform).position.x == 1.0


def test_a_class_of_a_program_may_use_a_function_of_another_class() -> None:
    class Corner:
        point = Point(x=1.0)

    TransformRegistration().add(Corner, do_transform_point)
    assert do_transform_point(Corner(), moved(angles=(0.0, 0.0, 0.0))).point.x == 2.0
