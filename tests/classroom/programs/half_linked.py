"""Begin links to a hub, and never finish them: as a laptop that gets out of reach.

Run: half_linked.py ADDRESS PORT COUNT
"""

from __future__ import annotations

import socket
import sys
import threading
import time

import zenoh

_DIAL_MS = 5000


def dial(port: int) -> None:
    """Begin a link to a port of this machine, which never answers."""
    config = zenoh.Config.from_json5(
        f"""{{mode: "client", scouting: {{multicast: {{enabled: false}}}},
        connect: {{endpoints: ["tcp/127.0.0.1:{port}"], timeout_ms: {_DIAL_MS}}}}}"""
    )
    with zenoh.open(config):
        pass


def first_message() -> bytes:
    """Return the first bytes that a client of Zenoh sends."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        threading.Thread(target=dial, args=(server.getsockname()[1],), daemon=True).start()
        connection, _ = server.accept()
        with connection:
            return connection.recv(65536)


def main() -> None:
    message = first_message()
    links = []
    for _ in range(int(sys.argv[3])):
        link = socket.create_connection((sys.argv[1], int(sys.argv[2])))
        link.sendall(message)
        links.append(link)
    print("linked half", flush=True)
    time.sleep(600)


if __name__ == "__main__":
    main()
