# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for all names of `tf2_sensor_msgs`."""

from zbot.libraries.cloud_transform import do_transform_cloud, transform_points

__all__ = [
    "do_transform_cloud",
    "transform_points",
]
