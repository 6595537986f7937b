"""Function that finds processes for a test, and a process that only waits."""

from zbot.launch.testing.error import NoMatchingProcessError as NoMatchingProcessException
from zbot.launch.testing.keep_alive_process import KeepAliveProc
from zbot.launch.testing.process_lookup import NO_CMD_ARGS, resolve_processes

resolveProcesses = resolve_processes  # noqa: N816 - launch_testing's name
