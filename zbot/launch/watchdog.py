"""Watchdog process that ends the processes of a launch if the launch itself is killed.

This file runs as a separate process in its own POSIX session. It reads the process groups of the
launch from a pipe. The pipe closes when the launch ends for any reason. Then the watchdog ends the
remaining groups. This file imports nothing from zbot, so that it starts fast.
"""

from __future__ import annotations

import os
import signal
import sys
import time

assert sys.platform != "win32"  # Windows has no process groups

_GRACE_S = 0.7
_INTERVAL_S = 0.02


def main() -> None:
    """Read `+group` and `-group` lines until the pipe closes, then end the remaining groups."""
    groups: set[int] = set()
    for line in sys.stdin:
        group = int(line[1:])
        if line.startswith("+"):
            groups.add(group)
        else:
            groups.discard(group)
    _signal(groups, signal.SIGTERM)
    deadline = time.monotonic() + _GRACE_S
    while groups and time.monotonic() < deadline:
        time.sleep(_INTERVAL_S)
        _signal(groups, 0)
    _signal(groups, signal.SIGKILL)


def _signal(groups: set[int], number: int) -> None:
    """Send a signal to each group, and remove groups without processes from the set."""
    for group in list(groups):
        try:
            os.killpg(group, number)
        except (ProcessLookupError, PermissionError):
            groups.discard(group)


if __name__ == "__main__":
    main()
