"""Exit codes of processes."""

from zbot.launch.testing.record import ExitRecord as ActiveProcInfoHandler
from zbot.launch.testing.record import ExitRecord as ProcInfoHandler
