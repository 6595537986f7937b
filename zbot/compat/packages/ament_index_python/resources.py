# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `InvalidResourceNameError` and `InvalidResourceTypeNameError` and `get_resource` and `get_resource_types` and `get_resources` and `has_resource`."""

from zbot.package.ament_index import (
    InvalidResourceNameError,
    InvalidResourceTypeNameError,
    get_resource,
    get_resource_types,
    get_resources,
    has_resource,
)

__all__ = [
    "InvalidResourceNameError",
    "InvalidResourceTypeNameError",
    "get_resource",
    "get_resource_types",
    "get_resources",
    "has_resource",
]
