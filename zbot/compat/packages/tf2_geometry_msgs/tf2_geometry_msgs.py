# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for all names of `tf2_geometry_msgs`."""

from zbot.tf2.conversion import (
    do_transform_point,
    do_transform_polygon_stamped,
    do_transform_pose,
    do_transform_pose_stamped,
    do_transform_pose_with_covariance_stamped,
    do_transform_vector3,
    do_transform_wrench,
    transform_covariance,
)
from geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    Vector3Stamped,
)

__all__ = [
    "Point",
    "Point32",
    "PointStamped",
    "PolygonStamped",
    "Pose",
    "PoseStamped",
    "PoseWithCovarianceStamped",
    "TransformStamped",
    "Vector3Stamped",
    "do_transform_point",
    "do_transform_polygon_stamped",
    "do_transform_pose",
    "do_transform_pose_stamped",
    "do_transform_pose_with_covariance_stamped",
    "do_transform_vector3",
    "do_transform_wrench",
    "transform_covariance",
]
