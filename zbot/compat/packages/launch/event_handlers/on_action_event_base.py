"""`OnActionEventBase` under its own module's name."""

from zbot.launch.event_handler import OnActionEventBase
