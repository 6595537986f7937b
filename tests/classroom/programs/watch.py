"""Print every node token that comes or goes at this machine's hub, with the time.

Run: watch.py [DOMAIN]...      all domains if none is named
Prints `up` or `down`, the monotonic time in nanoseconds, domain and node name, one event a line.
"""

from __future__ import annotations

import sys
import time

import zenoh

from zbot.transport.session import open_hub_client


def main() -> None:
    session = open_hub_client(more={"connect/timeout_ms": -1, "connect/exit_on_failure": False})
    assert session is not None, "the hub does not let this machine in"
    with session:
        events = zenoh.handlers.FifoChannel(10_000)
        watching = [
            session.liveliness().declare_subscriber(
                f"@zbot/{domain}/*/*/*/NN/**", events, history=True
            )
            for domain in sys.argv[1:] or ["*"]
        ]
        print("watching", time.monotonic_ns(), flush=True)
        for sample in watching[0].handler:
            kind = "up" if sample.kind == zenoh.SampleKind.PUT else "down"
            chunks = [chunk.replace("%", "/") for chunk in str(sample.key_expr).split("/")]
            node = f"{chunks[7].rstrip('/')}/{chunks[8]}"
            print(kind, time.monotonic_ns(), chunks[1], node, flush=True)


if __name__ == "__main__":
    main()
