"""Fault of Zenoh 1.10: each session that had an admin space leaves an open file behind.

Run: open_file_per_session.py
"""

from __future__ import annotations

import sys
from pathlib import Path

import zenoh

_SESSIONS = 20


def open_files() -> int:
    return len(list(Path("/proc/self/fd").iterdir()))


def main() -> int:
    config = zenoh.Config()
    config.insert_json5("adminspace/enabled", "true")
    config.insert_json5("scouting/multicast/enabled", "false")
    zenoh.open(config).close()
    before = open_files()
    for _ in range(_SESSIONS):
        zenoh.open(config).close()
    left = open_files() - before
    print(f"{left} open files are left after {_SESSIONS} sessions that were closed")
    return 1 if left >= _SESSIONS else 0


if __name__ == "__main__":
    sys.exit(main())
