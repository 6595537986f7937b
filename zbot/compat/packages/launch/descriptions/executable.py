"""`Executable` under its own module's name."""

from zbot.launch.actions.executable import Executable
