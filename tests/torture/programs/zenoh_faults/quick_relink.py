"""Fault of Zenoh 1.10: a router does not repeat its declarations on a link that comes back at once.

Run: quick_relink.py

Two routers are linked through a relay, which breaks the link. The second router dials again at
once. Shortly before, another link of the second router has changed.
"""

from __future__ import annotations

import contextlib
import json
import socket
import sys
import threading
import time

import zenoh

_ROUNDS = 20
_KEY = "token"


def _open(mode: str, port: int, connect: int | None, **more: object) -> zenoh.Session:
    config = zenoh.Config()
    settings = {
        "mode": mode,
        "listen/endpoints": [f"tcp/127.0.0.1:{port}"] if port else [],
        "connect/endpoints": [f"tcp/127.0.0.1:{connect}"] if connect else [],
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
        "connect/retry": {"period_init_ms": 5, "period_max_ms": 5, "period_increase_factor": 1},
        "scouting/multicast/enabled": False,
        **more,
    }
    for path, value in settings.items():
        config.insert_json5(path, json.dumps(value))
    return zenoh.open(config)


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as server:
        return int(server.getsockname()[1])


class _Relay:
    """Relay of TCP connections to a port."""

    def __init__(self, port: int) -> None:
        self._port = port
        self._server = socket.create_server(("127.0.0.1", 0))
        self.port = int(self._server.getsockname()[1])
        self._sockets: list[socket.socket] = []
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            near, _ = self._server.accept()
            far = socket.create_connection(("127.0.0.1", self._port))
            self._sockets = [near, far]
            for source, target in ((near, far), (far, near)):
                threading.Thread(target=self._pump, args=(source, target), daemon=True).start()

    @staticmethod
    def _pump(source: socket.socket, target: socket.socket) -> None:
        with contextlib.suppress(OSError):
            while data := source.recv(65536):
                target.sendall(data)

    def cut(self) -> None:
        """End the connection."""
        for socket_ in self._sockets:
            with contextlib.suppress(OSError):
                socket_.shutdown(socket.SHUT_RDWR)


def _knows_token(session: zenoh.Session) -> bool:
    return any(reply.ok for reply in session.liveliness().get(_KEY, timeout=1.0))


def _knows_token_within(session: zenoh.Session, timeout_s: float) -> bool:
    deadline = time.monotonic() + timeout_s
    while not _knows_token(session):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.05)
    return True


def main() -> int:
    port, other_port = _free_port(), _free_port()
    with _open("router", port, None) as first:
        relay = _Relay(port)
        with (
            _open("router", other_port, relay.port),
            _open("client", 0, other_port) as owner,
            owner.liveliness().declare_token(_KEY),
        ):
            for number in range(_ROUNDS):
                if not _knows_token_within(first, 5.0):
                    print(f"the token is missing after {number} broken links")
                    return 1
                # A change of the network of routers: the next change waits for 100 ms.
                with _open("router", 0, other_port):
                    pass
                relay.cut()
                time.sleep(0.5)
    print(f"the token was known after {_ROUNDS} broken links")
    return 0


if __name__ == "__main__":
    sys.exit(main())
