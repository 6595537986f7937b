"""Fault of Zenoh 1.10: Python does not end while a session has a subscriber in a thread.

Run: exit_with_open_session.py
"""

from __future__ import annotations

import subprocess
import sys

_SOURCE = """
import threading, zenoh
config = zenoh.Config()
config.insert_json5("scouting/multicast/enabled", "false")
session = zenoh.open(config)
subscriber = session.declare_subscriber("a", zenoh.handlers.FifoChannel(10))
{thread}
print("the program is over", flush=True)
"""
_THREADS = {
    "a thread that waits in recv()": "threading.Thread(target=subscriber.recv).start()",
    "a daemon thread that waits in recv()": (
        "threading.Thread(target=subscriber.recv, daemon=True).start()"
    ),
    "a callback": "other = session.declare_subscriber('b', print)",
}


def main() -> int:
    faults = 0
    for what, thread in _THREADS.items():
        words = [sys.executable, "-c", _SOURCE.format(thread=thread)]
        try:
            done = subprocess.run(words, timeout=5, capture_output=True, check=False)
        except subprocess.TimeoutExpired:
            print(f"{what}: the process does not end")
            faults += 1
        else:
            print(f"{what}: the process ends with {done.returncode}")
            faults += done.returncode != 0
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
