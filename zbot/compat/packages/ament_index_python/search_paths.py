# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `get_search_paths`."""

from zbot.package.ament_index import get_search_paths

__all__ = [
    "get_search_paths",
]
