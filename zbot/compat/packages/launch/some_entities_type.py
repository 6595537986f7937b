"""What may be given where entities are wanted."""

from zbot.launch.event_handler import Entities as SomeEntitiesType

__all__ = ["SomeEntitiesType"]
