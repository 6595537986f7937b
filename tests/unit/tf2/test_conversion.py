"""Tests of poses with covariance, wrenches and polygons in other frames."""

from __future__ import annotations

import numpy as np
import pytest

from zbot.tf2 import transformations as tf
from zbot.tf2.conversion import (
    do_transform_polygon_stamped,
    do_transform_pose,
    do_transform_pose_with_covariance_stamped,
    do_transform_wrench,
)

from geometry_msgs.msg import (
    Point32,
    PolygonStamped,
    Pose,
    PoseWithCovarianceStamped,
    Quaternion,
    TransformStamped,
    Vector3,
    WrenchStamped,
)

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
