"""Listen at this machine's hub to a pupil's words, and say how late they come.

Run: hear.py KEY [OTHER_KEY]...           such as 17/ana/words
Prints `hearing`, for each second of the monotonic clock `second SECOND COUNT P99_US` of the first
key, and when interrupted a line of JSON: delays_us by second, and how much came on the other keys.
"""

from __future__ import annotations

import json
import signal
import sys
import threading
import time
from typing import Any

import msgpack  # type: ignore[import-untyped]
import zenoh

from zbot.session import open_hub_client


class Ear:
    """What came, sorted by the second in which it was said."""

    def __init__(self, key: str) -> None:
        self._key = key
        self._second = 0
        self.delays_us: dict[int, list[int]] = {}
        self.others = 0

    def listen(self, channel: Any) -> None:
        for sample in channel:
            now_ns = time.monotonic_ns()
            if str(sample.key_expr) != self._key:
                self.others += 1
                continue
            sent_ns = int(msgpack.unpackb(sample.payload.to_bytes())["data"].split()[1])
            self._file(sent_ns // 10**9, (now_ns - sent_ns) // 1000)

    def _file(self, second: int, delay_us: int) -> None:
        if second > self._second:
            self._report(self.delays_us.get(self._second, []))
            self._second = second
        self.delays_us.setdefault(second, []).append(delay_us)

    def _report(self, delays_us: list[int]) -> None:
        if delays_us:
            p99_us = sorted(delays_us)[int(len(delays_us) * 0.99)]
            print("second", self._second, len(delays_us), p99_us, flush=True)


def main() -> None:
    session = open_hub_client(more={"connect/timeout_ms": -1, "connect/exit_on_failure": False})
    assert session is not None, "the hub does not let this machine in"
    ear = Ear(sys.argv[1])
    with session:
        channel = zenoh.handlers.FifoChannel(100_000)
        listening = [session.declare_subscriber(key, channel) for key in sys.argv[1:]]
        for one in listening:
            threading.Thread(target=ear.listen, args=(one.handler,), daemon=True).start()
        print("hearing", flush=True)
        signal.sigwait({signal.SIGINT, signal.SIGTERM})
    print(json.dumps({"delays_us": ear.delays_us, "others": ear.others}), flush=True)


if __name__ == "__main__":
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    main()
