"""Relay of TCP connections that can be cut, as a network cable: no end hears anything of it."""

from __future__ import annotations

import socket
import threading
from contextlib import suppress


class Relay:
    """Relay to a port of this machine.

    Args:
        port: The port of the server.

    Attributes:
        port: The port of the relay.
    """

    def __init__(self, port: int) -> None:
        self._server = port
        self._is_up = threading.Event()
        self._is_up.set()
        self._sockets: list[socket.socket] = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        with suppress(OSError):  # the relay is closed
            while True:
                client, _ = self._listener.accept()
                server = socket.create_connection(("127.0.0.1", self._server))
                self._sockets += (client, server)
                for ends in ((client, server), (server, client)):
                    threading.Thread(target=self._copy, args=ends, daemon=True).start()

    def _copy(self, source: socket.socket, target: socket.socket) -> None:
        with suppress(OSError):
            while data := source.recv(65536):
                self._is_up.wait()
                target.sendall(data)
            target.shutdown(socket.SHUT_WR)

    def cut(self) -> None:
        """Pass on nothing, until `mend`."""
        self._is_up.clear()

    def mend(self) -> None:
        """Pass on everything, also what was sent meanwhile."""
        self._is_up.set()

    def close(self) -> None:
        """Close all connections."""
        self._listener.close()
        self.mend()
        for socket_ in self._sockets:
            socket_.close()
