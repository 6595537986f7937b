"""Exit codes of the `zbot` command."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """Exit code of `zbot`, for shell scripts."""

    OK = 0
    ERROR = 1  #: something failed or was not found. A sentence on stderr says what
    USAGE = 2  #: the command line is invalid
    INTERRUPTED = 130  #: Ctrl-C: 128 + SIGINT, as in shells
    TERMINATED = 143  #: 128 + SIGTERM
