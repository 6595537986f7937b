"""A hub made of nothing but Zenoh: what zbot's own is compared with.

Run: plain_hub.py LISTEN [DIAL]      Zenoh endpoints, such as tcp/0.0.0.0:7447
"""

from __future__ import annotations

import json
import signal
import sys

import zenoh


def main() -> None:
    config = zenoh.Config()
    config.insert_json5("mode", '"router"')
    config.insert_json5("listen/endpoints", json.dumps([sys.argv[1]]))
    config.insert_json5("connect/endpoints", json.dumps(sys.argv[2:]))
    config.insert_json5("connect/timeout_ms", "-1")
    config.insert_json5("connect/exit_on_failure", "false")
    config.insert_json5("connect/retry", '{"period_init_ms": 20, "period_max_ms": 1000}')
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("transport/link/tx/lease", "4000")
    with zenoh.open(config):
        print("hub", flush=True)
        signal.sigwait({signal.SIGINT, signal.SIGTERM})


if __name__ == "__main__":
    main()
