"""What to execute."""

from zbot.launch.actions.executable import Executable as Executable
