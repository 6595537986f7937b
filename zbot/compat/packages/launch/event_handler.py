"""Event handlers of any kind."""

from zbot.launch.event_handler import BaseEventHandler, EventHandler
