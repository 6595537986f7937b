# Written by python -m zbot.compat.generator; do not edit.
"""Assertions about processes."""

from zbot.launch.testing.assertion import (
    EXIT_OK,
    EXIT_SIGINT,
    EXIT_SIGKILL,
    EXIT_SIGQUIT,
    EXIT_SIGSEGV,
    SequentialTextChecker,
    assertExitCodes,
    assertInStderr,
    assertInStdout,
    assertSequentialStdout,
)
from zbot.launch.testing.process_lookup import NO_CMD_ARGS

__all__ = [
    "EXIT_OK",
    "EXIT_SIGINT",
    "EXIT_SIGKILL",
    "EXIT_SIGQUIT",
    "EXIT_SIGSEGV",
    "NO_CMD_ARGS",
    "SequentialTextChecker",
    "assertExitCodes",
    "assertInStderr",
    "assertInStdout",
    "assertSequentialStdout",
]
