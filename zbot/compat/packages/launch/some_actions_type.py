"""Type of arguments that contain actions."""

from zbot.launch.event_handler import Entities as SomeActionsType
from zbot.launch.event_handler import Entities_types_tuple as SomeActionsType_types_tuple

__all__ = ["SomeActionsType", "SomeActionsType_types_tuple"]
