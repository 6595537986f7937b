"""How processes ended."""

from zbot.launch_test.record import ExitRecord as ActiveProcInfoHandler
from zbot.launch_test.record import ExitRecord as ProcInfoHandler
