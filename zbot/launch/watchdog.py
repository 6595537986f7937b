"""Ends the processes of a launch that was killed.

This file runs as a process of its own, in a session of its own. It reads which process groups there
are from a pipe; when the pipe is closed, the launch has ended, whichever way, and the groups that
are left are ended too. It imports nothing of zbot: it has to be there at once.
"""

from __future__ import annotations

import os
import signal
import sys
import time

_PATIENCE_S = 0.7
_INTERVAL_S = 0.02


def main() -> None:
    """Read `+group` and `-group` lines until the end, then end what is left."""
    groups: set[int] = set()
    for line in sys.stdin:
        group = int(line[1:])
        if line.startswith("+"):
            groups.add(group)
        else:
            groups.discard(group)
    _signal(groups, signal.SIGTERM)
    deadline = time.monotonic() + _PATIENCE_S
    while groups and time.monotonic() < deadline:
        time.sleep(_INTERVAL_S)
        _signal(groups, 0)
    _signal(groups, signal.SIGKILL)


def _signal(groups: set[int], number: int) -> None:
    """Send a signal to each group; forget those that are gone."""
    for group in list(groups):
        try:
            os.killpg(group, number)
        except (ProcessLookupError, PermissionError):
            groups.discard(group)


if __name__ == "__main__":
    main()
