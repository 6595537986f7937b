# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `tf2_geometry_msgs`: points, vectors and poses in other frames."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
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

if TYPE_CHECKING:
    from . import tf2_geometry_msgs as tf2_geometry_msgs
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "tf2_geometry_msgs",
        ),
    )[0]
