"""Fault of Zenoh 1.10: a query for `@/**` can block a router for ever.

Zenoh holds a lock while it answers such a query, and takes the lock again for the reply. If another
session declares something in between, the router blocks (pull request 2619 of eclipse-zenoh/zenoh).

Run: admin_query_deadlock.py
"""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys

import zenoh

_TRIES = 200
_SESSION = """
import json, sys, time, zenoh
mode, end, port, work = sys.argv[1:]
config = zenoh.Config()
config.insert_json5("mode", json.dumps(mode))
config.insert_json5(f"{end}/endpoints", json.dumps([f"tcp/127.0.0.1:{port}"]))
config.insert_json5("scouting/multicast/enabled", "false")
config.insert_json5("adminspace/enabled", "true")
session = zenoh.open(config)
print("ready", flush=True)
while work == "declare":
    session.declare_subscriber("a", zenoh.handlers.FifoChannel(1)).undeclare()
time.sleep(600)
"""


def client(port: int) -> zenoh.Session:
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", json.dumps([f"tcp/127.0.0.1:{port}"]))
    config.insert_json5("connect/timeout_ms", "2000")
    config.insert_json5("connect/exit_on_failure", "true")
    config.insert_json5("scouting/multicast/enabled", "false")
    return zenoh.open(config)


def start(*words: str) -> subprocess.Popen[bytes]:
    process = subprocess.Popen([sys.executable, "-c", _SESSION, *words], stdout=subprocess.PIPE)
    assert process.stdout is not None
    process.stdout.readline()
    return process


def is_answering(session: zenoh.Session) -> bool:
    routers = list(session.info.routers_zid())
    return any(reply.ok for zid in routers for reply in session.get(f"@/{zid}/router", timeout=3.0))


def main() -> int:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = str(free.getsockname()[1])
    processes = [start("router", "listen", port, "sleep")]
    processes += [start("client", "connect", port, "declare") for _ in range(3)]
    try:
        session = client(int(port))
        for number in range(_TRIES):
            list(session.get("@/**", timeout=0.5))
            if not is_answering(session):
                print(f"fault: the router answers nothing after {number + 1} queries", flush=True)
                return 1
    except zenoh.ZError as error:
        print(f"fault: {error}", flush=True)
        return 1
    finally:
        for process in processes:
            process.kill()
            process.wait()
    print(f"no fault in {_TRIES} queries", flush=True)
    return 0


if __name__ == "__main__":
    os._exit(main())  # closing the session would wait for the router
