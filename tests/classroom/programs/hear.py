"""Listen at this machine's hub to pupils' words, without zbot.

Run: hear.py KEY...           such as 17/ana/words
Prints `hearing`, and when interrupted a line of JSON: for each key the list of [number, sent_ns,
delay_us], and how many messages came whose text holds no such numbers.
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


def main() -> None:
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", json.dumps(["tcp/127.0.0.1:7447"]))
    config.insert_json5("connect/timeout_ms", "-1")
    config.insert_json5("connect/exit_on_failure", "false")
    config.insert_json5("connect/retry", '{"period_init_ms": 20, "period_max_ms": 100}')
    config.insert_json5("scouting/multicast/enabled", "false")
    heard: dict[str, list[Any]] = {}
    others: dict[str, int] = {}

    def take(channel: Any) -> None:
        for sample in channel:
            now = time.monotonic_ns()
            key, text = str(sample.key_expr), msgpack.unpackb(sample.payload.to_bytes())["data"]
            try:
                number, sent_ns = map(int, text.split())
            except ValueError:
                others[key] = others.get(key, 0) + 1
                continue
            heard.setdefault(key, []).append((number, sent_ns, (now - sent_ns) // 1000))

    with zenoh.open(config) as session:
        channel = zenoh.handlers.FifoChannel(100_000)
        listening = [session.declare_subscriber(key, channel) for key in sys.argv[1:]]
        for one in listening:
            threading.Thread(target=take, args=(one.handler,), daemon=True).start()
        print("hearing", flush=True)
        signal.sigwait({signal.SIGINT, signal.SIGTERM})
    print(json.dumps({"heard": heard, "others": others}), flush=True)


if __name__ == "__main__":
    signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})
    main()
