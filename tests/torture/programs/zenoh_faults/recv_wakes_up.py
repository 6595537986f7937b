"""Fault of Zenoh's Python binding 1.10: `recv()` wakes ten times a second, in each thread.

Run: recv_wakes_up.py
"""

from __future__ import annotations

import sys
import threading
import time
from pathlib import Path

import zenoh

_THREADS = 10
_WATCH_S = 2.0


def switches() -> int:
    """Return how often the threads of this process have slept."""
    found = 0
    for path in Path("/proc/self/task").glob("*/status"):
        for line in path.read_text(encoding="ascii").splitlines():
            if line.startswith("voluntary_ctxt_switches:"):
                found += int(line.split()[1])
    return found


def rate() -> float:
    before = switches()
    time.sleep(_WATCH_S)
    return (switches() - before) / _WATCH_S


def main() -> int:
    config = zenoh.Config()
    config.insert_json5("scouting/multicast/enabled", "false")
    with zenoh.open(config) as session:
        channel = zenoh.handlers.FifoChannel(10)
        subscribers = [session.declare_subscriber(f"a{n}", channel) for n in range(_THREADS)]
        idle = rate()
        threads = [
            threading.Thread(target=_receive, args=(subscriber,)) for subscriber in subscribers
        ]
        for thread in threads:
            thread.start()
        waiting = rate()
    for thread in threads:
        thread.join()
    print(f"{idle:.0f} wake-ups a second, and {waiting:.0f} with {_THREADS} threads in recv()")
    return 1 if waiting - idle > 5 * _THREADS else 0


def _receive(subscriber: zenoh.Subscriber[zenoh.handlers.Handler[zenoh.Sample]]) -> None:
    try:
        subscriber.recv()
    except zenoh.ZError:
        return


if __name__ == "__main__":
    sys.exit(main())
