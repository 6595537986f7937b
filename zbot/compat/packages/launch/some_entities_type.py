"""Type of arguments that contain entities."""

from zbot.launch.event_handler import Entities as SomeEntitiesType
from zbot.launch.event_handler import Entities_types_tuple as SomeEntitiesType_types_tuple

__all__ = ["SomeEntitiesType", "SomeEntitiesType_types_tuple"]
