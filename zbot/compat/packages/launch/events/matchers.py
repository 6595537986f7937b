"""Functions that check which action an event is about."""

from zbot.launch.process_event import matches_action
