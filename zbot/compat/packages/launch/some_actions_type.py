"""What may be given where actions are wanted."""

from zbot.launch.event_handler import Entities as SomeActionsType

__all__ = ["SomeActionsType"]
