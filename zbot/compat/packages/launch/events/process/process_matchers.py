"""Functions that check which process an event is about."""

from zbot.launch.process_event import matches_executable, matches_name, matches_pid
