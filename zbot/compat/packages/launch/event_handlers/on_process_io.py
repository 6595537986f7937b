"""`OnProcessIO` under its own module's name."""

from zbot.launch.event_handler import OnProcessIO
