"""Fault of Zenoh 1.10: a key of more than 64 KB ends or blocks the process that uses it.

Run: key_too_long.py
"""

from __future__ import annotations

import subprocess
import sys

_SOURCE = """
import json, sys, zenoh
def opened(**paths):
    config = zenoh.Config()
    config.insert_json5("scouting/multicast/enabled", "false")
    for path, value in paths.items():
        config.insert_json5(path.replace("_", "/"), json.dumps(value))
    return zenoh.open(config)
import socket
with socket.create_server(("127.0.0.1", 0)) as free:
    port = free.getsockname()[1]
router = opened(mode="router", listen_endpoints=[f"tcp/127.0.0.1:{port}"])
client = opened(mode="client", connect_endpoints=[f"tcp/127.0.0.1:{port}"])
heard = []
watcher = router.declare_subscriber("**", heard.append)
long = "/".join("x" * 100 for _ in range(700))
try:
    client.put(long, b"x")
except zenoh.ZError as error:
    print("an error that a program can handle:", str(error)[:60])
client.put("after", b"x")
import time
deadline = time.monotonic() + 2
while time.monotonic() < deadline and not any(str(one.key_expr) == "after" for one in heard):
    time.sleep(0.01)
works = any(str(one.key_expr) == "after" for one in heard)
print("the next message arrives" if works else "the next message does not arrive", flush=True)
import os
os._exit(0 if works else 1)
"""


def main() -> int:
    words = [sys.executable, "-c", _SOURCE]
    try:
        done = subprocess.run(words, timeout=10, capture_output=True, text=True, check=False)
    except subprocess.TimeoutExpired:
        print("the process blocks")
        return 1
    print(done.stdout.strip(), done.stderr.strip()[:300])
    return 1 if done.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
