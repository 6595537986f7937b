"""Fault of Zenoh's Python binding 1.10: an undeclared advanced subscriber still asks publishers.

Run: undeclared_subscriber_asks.py

This happens if the handler is a mere callback. With a pair of a callback and any object, it does
not happen.
"""

from __future__ import annotations

import sys
import time

import zenoh
from zenoh import ext

_KEY = "latched"
_WAIT_S = 1.0


def main() -> int:
    config = zenoh.Config()
    config.insert_json5("scouting/multicast/enabled", "false")
    asked: list[zenoh.Query] = []
    with zenoh.open(config) as session:
        subscriber = ext.declare_advanced_subscriber(
            session,
            _KEY,
            lambda _: None,
            history=ext.HistoryConfig(detect_late_publishers=True),
        )
        subscriber.undeclare()
        session.declare_queryable(f"{_KEY}/@adv/pub/**", asked.append)
        publisher = ext.declare_advanced_publisher(
            session,
            _KEY,
            cache=ext.CacheConfig(1),
            publisher_detection=True,
            sample_miss_detection=ext.MissDetectionConfig(heartbeat=None, sporadic_heartbeat=None),
        )
        end = time.monotonic() + _WAIT_S
        while not asked and time.monotonic() < end:
            time.sleep(0.01)
        publisher.undeclare()
        print(f"an undeclared subscriber sent {len(asked)} queries")
        is_there = bool(asked)
        asked.clear()  # a query that is kept would never end
    return 1 if is_there else 0


if __name__ == "__main__":
    sys.exit(main())
