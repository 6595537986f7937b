"""Which processes a test means; a process that only waits."""

from zbot.launch.testing.error import NoMatchingProcessError as NoMatchingProcessException
from zbot.launch.testing.keep_alive_process import KeepAliveProc as KeepAliveProc
from zbot.launch.testing.process_lookup import NO_CMD_ARGS as NO_CMD_ARGS
from zbot.launch.testing.process_lookup import resolve_processes

resolveProcesses = resolve_processes  # noqa: N816 - launch_testing's name
