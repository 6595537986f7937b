# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `make_namespace_absolute` and `is_namespace_absolute` and `is_root_namespace` and `prefix_namespace`."""

from zbot.launch.actions.ros_names import (
    absolute as make_namespace_absolute,
    is_namespace_absolute,
    is_root_namespace,
    prefix_namespace,
)

__all__ = [
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "prefix_namespace",
]
