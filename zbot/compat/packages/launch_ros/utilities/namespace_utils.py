"""Functions for namespaces."""

from zbot.launch.actions.ros_names import absolute as make_namespace_absolute
from zbot.launch.actions.ros_names import is_namespace_absolute, is_root_namespace, prefix_namespace

__all__ = [
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "prefix_namespace",
]
