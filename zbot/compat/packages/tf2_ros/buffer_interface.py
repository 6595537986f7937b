# Written by python -m zbot.compat.generator; do not edit.
"""Conversion and transformation of messages."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.tf2.buffer_interface import (
    BufferInterface,
    ConvertRegistration,
    TransformRegistration,
    convert,
)
from zbot.tf2.errors import NotImplementedException, TypeException

__all__ = [
    "BufferInterface",
    "ConvertRegistration",
    "Duration",
    "Header",
    "NotImplementedException",
    "PointCloud2",
    "PointStamped",
    "PoseStamped",
    "PoseWithCovarianceStamped",
    "Time",
    "TransformRegistration",
    "TransformStamped",
    "TypeException",
    "Vector3Stamped",
    "convert",
]

if TYPE_CHECKING:
    from geometry_msgs.msg import PointStamped as PointStamped
    from geometry_msgs.msg import PoseStamped as PoseStamped
    from geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceStamped
    from geometry_msgs.msg import TransformStamped as TransformStamped
    from geometry_msgs.msg import Vector3Stamped as Vector3Stamped
    from sensor_msgs.msg import PointCloud2 as PointCloud2
    from std_msgs.msg import Header as Header
    from zbot.time import Duration as Duration
    from zbot.time import Time as Time
else:
    __getattr__ = lazy_names(
        __name__,
        {
            "geometry_msgs.msg": "PointStamped PoseStamped PoseWithCovarianceStamped TransformStamped Vector3Stamped",
            "sensor_msgs.msg": "PointCloud2",
            "std_msgs.msg": "Header",
            "zbot.time": "Duration Time",
        },
        submodules=(
        ),
    )[0]
