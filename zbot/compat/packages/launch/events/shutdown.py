"""`Shutdown` under its own module's name."""

from zbot.launch.event import Shutdown
