"""Which process an event is about."""

from zbot.launch.process_event import matches_executable as matches_executable
from zbot.launch.process_event import matches_name as matches_name
from zbot.launch.process_event import matches_pid as matches_pid
