# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SomeEntitiesType` and `SomeEntitiesType_types_tuple`."""

from zbot.launch.event_handler import (
    Entities as SomeEntitiesType,
    Entities_types_tuple as SomeEntitiesType_types_tuple,
)

__all__ = [
    "SomeEntitiesType",
    "SomeEntitiesType_types_tuple",
]
