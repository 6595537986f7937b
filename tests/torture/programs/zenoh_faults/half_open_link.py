"""Fault of Zenoh 1.10: a dial that is given up in its last step leaves a link that never reads.

Run: half_open_link.py
"""

from __future__ import annotations

import json
import sys
import threading
import time

import zenoh

_ENDPOINT = "tcp/127.0.0.1:17475"
_TRIES = 400
_LONGEST_MS = 20  # a dial takes 1 to 20 ms
_READ_TIMEOUT_S = 2.0  # a link that reads needs a few milliseconds
_PAUSE_S = 0.01


def configuration(**values: object) -> zenoh.Config:
    config: zenoh.Config = zenoh.Config()
    for path, value in {"mode": "peer", "scouting/multicast/enabled": False, **values}.items():
        config.insert_json5(path, json.dumps(value))
    return config


def is_half_open(timeout_ms: int, publisher: zenoh.Publisher) -> bool:
    """Dial with a limit, and return whether there is a link on which nothing is read."""
    settings = {
        "listen/endpoints": [],
        "connect/endpoints": [_ENDPOINT],
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
        "scouting/delay": 1,
        "transport/unicast/open_timeout": timeout_ms,
    }
    was_read = threading.Event()
    with zenoh.open(configuration(**settings)) as session:
        session.declare_subscriber("word", lambda _: was_read.set())
        deadline = time.monotonic() + _READ_TIMEOUT_S
        while time.monotonic() < deadline and not was_read.is_set():
            publisher.put("word")
            time.sleep(_PAUSE_S)
        return not was_read.is_set() and bool(session.info.peers_zid())


def main() -> int:
    with zenoh.open(configuration(**{"listen/endpoints": [_ENDPOINT]})) as session:
        publisher = session.declare_publisher("word")
        for number in range(_TRIES):
            session.declare_subscriber(f"declaration{number}", zenoh.handlers.FifoChannel(1))
            if is_half_open(1 + number % _LONGEST_MS, publisher):
                print(f"dial {number + 1} was given up, and its link never reads")
                return 1
    print(f"all {_TRIES} links read")
    return 0


if __name__ == "__main__":
    sys.exit(main())
