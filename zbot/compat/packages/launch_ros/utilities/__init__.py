# Written by python -m zbot.compat.generator; do not edit.
"""Helpers for launch files and their tests."""

from typing import TYPE_CHECKING

from zbot.lazy_imports import lazy_names
from zbot.launch.actions.ros_names import (
    absolute as make_namespace_absolute,
    is_namespace_absolute,
    is_root_namespace,
    prefix_namespace,
)
from zbot.launch.actions.node import add_node_name, get_node_name_count
from .evaluate_parameters import evaluate_parameters
from .normalize_parameters import normalize_parameters

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

if TYPE_CHECKING:
    from . import namespace_utils as namespace_utils
    from . import track_node_names as track_node_names
else:
    __getattr__ = lazy_names(
        __name__,
        {
        },
        submodules=(
            "namespace_utils",
            "track_node_names",
        ),
    )[0]
