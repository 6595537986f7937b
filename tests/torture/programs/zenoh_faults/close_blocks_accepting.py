"""Fault of Zenoh 1.10: closing a link to a computer out of reach stops the accepting of links.

Zenoh sets the option SO_LINGER of its sockets to 10 s, and closes a socket in the one thread that
accepts links. The program needs Linux, and makes a network namespace of its own.

Run: close_blocks_accepting.py
"""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import time

import zenoh

_PORT = 17476
_ACCEPT_MS = 1000
_FAR = "10.9.9.9"  # an address of the computer that is out of reach later
_LONGEST_S = 3.0  # a dial takes some milliseconds
_INSIDE = "INSIDE_NAMESPACE"


def configuration(**values: object) -> zenoh.Config:
    config: zenoh.Config = zenoh.Config()
    for path, value in {"scouting/multicast/enabled": False, **values}.items():
        config.insert_json5(path, json.dumps(value))
    return config


def dial(port: int, timeout_s: float) -> float:
    """Open a session with a client's link. Return the time that this took, in seconds."""
    begin = time.monotonic()
    settings = {
        "mode": "client",
        "connect/endpoints": [f"tcp/127.0.0.1:{port}"],
        "connect/timeout_ms": int(1000 * timeout_s),
    }
    try:
        zenoh.open(configuration(**settings)).close()
    except zenoh.ZError:
        return timeout_s
    return time.monotonic() - begin


def first_message() -> bytes:
    """Return the first bytes that a client of Zenoh sends."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        words = [sys.executable, __file__, "dial", str(server.getsockname()[1])]
        with subprocess.Popen(words) as client:
            connection, _ = server.accept()
            with connection:
                message = connection.recv(65536)
            client.kill()
    return message


def listen() -> None:
    endpoint = f"tcp/127.0.0.1:{_PORT}"
    settings = {"listen/endpoints": [endpoint], "transport/unicast/accept_timeout": _ACCEPT_MS}
    with zenoh.open(configuration(mode="router", **settings)):
        print("listening", flush=True)
        signal.pause()


def measure() -> float:
    """Return how long a dial takes while the listener closes a link to a far computer."""
    message = first_message()
    ip = ["ip", "addr", "add", f"{_FAR}/32", "dev", "lo"]
    subprocess.run(ip, check=True)
    words = [sys.executable, __file__, "listen"]
    with subprocess.Popen(words, stdout=subprocess.PIPE) as listener:
        assert listener.stdout is not None
        listener.stdout.readline()
        # The listener answers only when the far computer is out of reach.
        listener.send_signal(signal.SIGSTOP)
        with socket.create_connection(("127.0.0.1", _PORT), source_address=(_FAR, 0)) as far:
            far.sendall(message)
            subprocess.run([*ip[:2], "del", *ip[3:]], check=True)
            listener.send_signal(signal.SIGCONT)
            time.sleep(_ACCEPT_MS / 1000 + 0.5)
            took_s = dial(_PORT, 20.0)
        listener.kill()
    return took_s


def main() -> int:
    if sys.argv[1:2] == ["listen"]:
        listen()
    elif sys.argv[1:2] == ["dial"]:
        dial(int(sys.argv[2]), 20.0)
    elif _INSIDE not in os.environ:
        words = ["unshare", "--user", "--map-root-user", "--net", sys.executable, __file__]
        return subprocess.run(words, env={**os.environ, _INSIDE: "1"}, check=False).returncode
    else:
        subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
        took_s = measure()
        print(f"a dial took {took_s:.1f} s")
        return int(took_s > _LONGEST_S)
    return 0


if __name__ == "__main__":
    sys.exit(main())
