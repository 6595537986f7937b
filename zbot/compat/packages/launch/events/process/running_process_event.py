"""`RunningProcessEvent` under its own module's name."""

from zbot.launch.process_event import RunningProcessEvent
