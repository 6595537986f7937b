"""Namespaces inside each other."""

from zbot.launch.actions.ros_names import absolute as make_namespace_absolute
from zbot.launch.actions.ros_names import is_namespace_absolute as is_namespace_absolute
from zbot.launch.actions.ros_names import is_root_namespace as is_root_namespace
from zbot.launch.actions.ros_names import prefix_namespace as prefix_namespace

__all__ = [
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "prefix_namespace",
]
