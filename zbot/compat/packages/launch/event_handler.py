# Written by python -m zbot.compat.generator; do not edit.
"""Event handlers of any kind."""

from zbot.launch.event_handler import BaseEventHandler, EventHandler

__all__ = [
    "BaseEventHandler",
    "EventHandler",
]
