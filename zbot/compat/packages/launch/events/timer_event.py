"""`TimerEvent` under its own module's name."""

from zbot.launch.event import TimerEvent
