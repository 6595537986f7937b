"""Fault of Zenoh 1.10: a put that waits for room hears no signal, and the session cannot be closed.

Run: blocked_put.py
"""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time

_SUBSCRIBER = """
import json, sys, zenoh
config = zenoh.Config()
config.insert_json5("listen/endpoints", json.dumps(["tcp/127.0.0.1:0"]))
config.insert_json5("scouting/multicast/enabled", "false")
config.insert_json5("adminspace/enabled", "true")
session = zenoh.open(config)
subscriber = session.declare_subscriber("a", zenoh.handlers.FifoChannel(1))
reply = next(iter(session.get(f"@/{session.info.zid()}/peer")))
print(json.loads(reply.ok.payload.to_bytes())["locators"][0], flush=True)
sys.stdin.read()
"""
_PUBLISHER = """
import json, sys, zenoh
config = zenoh.Config()
config.insert_json5("connect/endpoints", json.dumps([sys.argv[1]]))
config.insert_json5("scouting/multicast/enabled", "false")
wait = "transport/link/tx/queue/congestion_control/block/wait_before_close"
config.insert_json5(wait, "60000000")
session = zenoh.open(config)
block = zenoh.CongestionControl.BLOCK
publisher = session.declare_publisher("a", congestion_control=block)
while not publisher.matching_status.matching:
    pass
number = 0
while True:
    publisher.put(b"x" * 100_000)
    number += 1
    print(number, flush=True)
"""
_BLOCKED_S = 2.0


def main() -> int:
    start = [sys.executable, "-c"]
    pipe = subprocess.PIPE
    subscriber = subprocess.Popen([*start, _SUBSCRIBER], stdin=pipe, stdout=pipe, text=True)
    assert subscriber.stdout is not None
    locator = subscriber.stdout.readline().strip()
    assert json.dumps(locator)
    publisher = subprocess.Popen(
        [*start, _PUBLISHER, locator], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        time.sleep(_BLOCKED_S)
        publisher.send_signal(signal.SIGINT)
        publisher.wait(5)
    except subprocess.TimeoutExpired:
        print("the put blocks, and Ctrl-C does not end the program within 5 s")
        return 1
    finally:
        publisher.kill()
        subscriber.kill()
        publisher.wait()
        subscriber.wait()
    print("Ctrl-C ends the program")
    return 0


if __name__ == "__main__":
    sys.exit(main())
