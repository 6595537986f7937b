# Written by python -m zbot.compat.generator; do not edit.
"""ROS 2's module for `SomeActionsType` and `SomeActionsType_types_tuple`."""

from zbot.launch.event_handler import (
    Entities as SomeActionsType,
    Entities_types_tuple as SomeActionsType_types_tuple,
)

__all__ = [
    "SomeActionsType",
    "SomeActionsType_types_tuple",
]
