"""Exit codes of the `zbot` command."""

from __future__ import annotations

from enum import IntEnum


class Status(IntEnum):
    """What a shell script can tell from how `zbot` ended."""

    OK = 0
    ERROR = 1  #: something failed or was not found; a sentence on stderr says what
    USAGE = 2  #: the command line makes no sense
    INTERRUPTED = 130  #: Ctrl-C, as shells count it: 128 + SIGINT
    TERMINATED = 143  #: SIGTERM, counted likewise
