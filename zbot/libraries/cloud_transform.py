"""Transformation of point clouds: the functions of `tf2_sensor_msgs`.

This module needs numpy, which `pip install "zbot[numpy]"` installs.
"""

from __future__ import annotations

import copy
import sys
from typing import TYPE_CHECKING, Any

from zbot.errors import require_numpy
from zbot.executor.errors import WrongObjectError
from zbot.libraries.point_cloud import read_points
from zbot.tf2 import conversion
from zbot.tf2.errors import kind_of
from zbot.tf2.rigid import normalized

from sensor_msgs.msg import PointCloud2

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def transform_points(point_cloud: ArrayLike, transform: Any) -> NDArray[np.float64]:
    """Return points in the transform's parent frame, as an array of shape (points, 3)."""
    require_numpy("tf2_sensor_msgs")
    import numpy as np  # noqa: PLC0415 - part of an extra

    motion = conversion.rigid(transform)
    try:
        motion = motion._replace(rotation=normalized(motion.rotation))
    except ZeroDivisionError:
        motion = motion._replace(rotation=(0.0, 0.0, 0.0, 1.0))
    origin = np.array(motion.translation)
    axes = np.array([motion.apply(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]) - origin
    moved: NDArray[np.float64] = np.asarray(point_cloud, np.float64) @ axes + origin
    return moved


def do_transform_cloud(cloud: Any, transform: Any) -> Any:
    """Return a `PointCloud2` in the transform's parent frame. Only x, y and z change.

    Raises:
        WrongObjectError: `cloud` is not a point cloud.
        PointCloudError: The cloud has no x, y or z, or less data than its size needs.
    """
    require_numpy("tf2_sensor_msgs")
    if not hasattr(cloud, "point_step"):
        raise WrongObjectError(
            f"do_transform_cloud needs a PointCloud2, not {kind_of(cloud)}: "
            "write do_transform_cloud(cloud, transform)"
        )
    from numpy.lib.recfunctions import structured_to_unstructured  # noqa: PLC0415 - part of an extra

    moved = transform_points(
        structured_to_unstructured(read_points(cloud, ["x", "y", "z"])), transform
    )
    points = read_points(cloud).copy()
    for index, name in enumerate("xyz"):
        points[name] = moved[:, index]
    header = getattr(transform, "header", cloud.header)
    return PointCloud2(
        header=copy.deepcopy(header),
        height=cloud.height,
        width=cloud.width,
        fields=copy.deepcopy(cloud.fields),
        is_bigendian=sys.byteorder == "big",
        point_step=cloud.point_step,
        row_step=cloud.point_step * cloud.width,
        data=points.tobytes(),
        is_dense=cloud.is_dense,
    )


conversion.add(PointCloud2, do_transform_cloud)
