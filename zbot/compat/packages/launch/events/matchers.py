"""Which action an event is about."""

from zbot.launch.process_event import matches_action as matches_action
