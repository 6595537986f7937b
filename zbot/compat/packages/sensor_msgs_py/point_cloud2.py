# Written by python -m zbot.compat.generator; do not edit.
"""Point clouds as numpy arrays and back."""

from zbot.libraries.point_cloud import (
    create_cloud,
    create_cloud_xyz32,
    dtype_from_fields,
    read_points,
    read_points_list,
    read_points_numpy,
)
from sensor_msgs.msg import PointCloud2, PointField

__all__ = [
    "PointCloud2",
    "PointField",
    "create_cloud",
    "create_cloud_xyz32",
    "dtype_from_fields",
    "read_points",
    "read_points_list",
    "read_points_numpy",
]
