# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's `tf2_sensor_msgs`: point clouds in other frames."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.libraries.cloud_transform import do_transform_cloud, transform_points

__all__ = [
    "do_transform_cloud",
    "transform_points",
]

if TYPE_CHECKING:
    from . import tf2_sensor_msgs as tf2_sensor_msgs
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "tf2_sensor_msgs",
        ),
    )[0]
