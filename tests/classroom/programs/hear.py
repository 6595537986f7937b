"""Listen at this machine's hub to a pupil's words, and say how late they come.

Run: hear.py KEY [OTHER_KEY]... [--beat 1]      keys such as 17/ana/words, a beat in seconds
Prints `hearing`, for each beat of the monotonic clock `beat BEAT COUNT P99_US` of the first key,
and when interrupted a line of JSON: delays_us by beat, and how much came on the other keys.
"""

from __future__ import annotations

import argparse
import json
import signal
import threading
import time
from typing import Any

import msgpack  # type: ignore[import-untyped]
import zenoh

from zbot.transport.session import open_hub_client


class Ear:
    """What came, sorted by the beat in which it was said."""

    def __init__(self, key: str, beat_s: float) -> None:
        self._key = key
        self._beat_ns = int(beat_s * 1e9)
        self._beat = 0
        self.delays_us: dict[int, list[int]] = {}
        self.others = 0

    def listen(self, channel: Any) -> None:
        for sample in channel:
            now_ns = time.monotonic_ns()
            if str(sample.key_expr) != self._key:
                self.others += 1
                continue
            sent_ns = int(msgpack.unpackb(sample.payload.to_bytes())["data"].split()[1])
            self._file(sent_ns // self._beat_ns, (now_ns - sent_ns) // 1000)

    def _file(self, beat: int, delay_us: int) -> None:
        if beat > self._beat:
            self._report(self.delays_us.get(self._beat, []))
            self._beat = beat
        self.delays_us.setdefault(beat, []).append(delay_us)

    def _report(self, delays_us: list[int]) -> None:
        if delays_us:
            p99_us = sorted(delays_us)[int(len(delays_us) * 0.99)]
            print("beat", self._beat, len(delays_us), p99_us, flush=True)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("keys", nargs="+")
    parser.add_argument("--beat", type=float, default=1)
    options = parser.parse_args()
    session = open_hub_client(more={"connect/timeout_ms": -1, "connect/exit_on_failure": False})
    assert session is not None, "the hub does not let this machine in"
    ear = Ear(options.keys[0], options.beat)
    with session:
        channel = zenoh.handlers.FifoChannel(100_000)
        listening = [session.declare_subscriber(key, channel) for key in options.keys]
        for subscriber in listening:
            threading.Thread(target=ear.listen, args=(subscriber.handler,), daemon=True).start()
        print("hearing", flush=True)
        signal.sigwait({signal.SIGINT, signal.SIGTERM})
    print(json.dumps({"delays_us": ear.delays_us, "others": ear.others}), flush=True)


if __name__ == "__main__":
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    main()
