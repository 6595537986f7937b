# Written by python -m zbot.compat.generator; do not edit.
"""Function that finds processes for a test, and a process that only waits."""

from zbot.launch.testing.error import NoMatchingProcessError as NoMatchingProcessException
from zbot.launch.testing.test_action import KeepAliveProc
from zbot.launch.testing.process_lookup import (
    NO_CMD_ARGS,
    resolve_processes,
    resolve_processes as resolveProcesses,
)

__all__ = [
    "KeepAliveProc",
    "NO_CMD_ARGS",
    "NoMatchingProcessException",
    "resolveProcesses",
    "resolve_processes",
]
