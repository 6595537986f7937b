"""Event handlers of any kind."""

from zbot.launch.event_handler import BaseEventHandler as BaseEventHandler
from zbot.launch.event_handler import EventHandler as EventHandler
