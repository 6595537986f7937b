"""Fault of Zenoh 1.10: a link never frees the number of a key, and searches for free numbers.

Run: numbers_of_keys.py

A session declares tokens with ever new keys, and removes each of them immediately. After 65,535
keys, the search would never end.
"""

from __future__ import annotations

import json
import os
import socket
import sys
import time

import zenoh

_BLOCK = 1000
_BLOCKS = 6
_SLOWER = 2.0  # times


def opened(mode: str, place: str, port: int) -> zenoh.Session:
    config = zenoh.Config()
    config.insert_json5("mode", json.dumps(mode))
    config.insert_json5(f"{place}/endpoints", json.dumps([f"tcp/127.0.0.1:{port}"]))
    config.insert_json5("scouting/multicast/enabled", "false")
    return zenoh.open(config)


def cycle_us(session: zenoh.Session, begin: int) -> float:
    start = time.perf_counter()
    for number in range(begin, begin + _BLOCK):
        session.liveliness().declare_token(f"token/{number}").undeclare()
    return (time.perf_counter() - start) / _BLOCK * 1e6


def main() -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    router = opened("router", "listen", port)
    session = opened("client", "connect", port)
    blocks_us = [cycle_us(session, number * _BLOCK) for number in range(_BLOCKS)]
    print(f"{blocks_us[0]:.0f} us for a key at first, {blocks_us[-1]:.0f} us after 5,000 keys")
    sys.stdout.flush()
    assert not router.is_closed()
    os._exit(1 if blocks_us[-1] > _SLOWER * blocks_us[0] else 0)


if __name__ == "__main__":
    main()
