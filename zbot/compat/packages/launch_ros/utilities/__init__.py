"""Helpers for launch files and their tests."""

from zbot.launch.actions.ros_names import absolute as make_namespace_absolute
from zbot.launch.actions.ros_names import (
    is_namespace_absolute,
    is_root_namespace,
    prefix_namespace,
)
from zbot.launch.node_names import add_node_name, get_node_name_count
from zbot.launch.parameters import evaluate_parameters, normalize_parameters

__all__ = [
    "add_node_name",
    "evaluate_parameters",
    "get_node_name_count",
    "is_namespace_absolute",
    "is_root_namespace",
    "make_namespace_absolute",
    "normalize_parameters",
    "prefix_namespace",
]
