"""Proxy that records what an eavesdropper on a machine's network can read."""

from __future__ import annotations

import contextlib
import socket
import threading
from functools import partial
from typing import TYPE_CHECKING

from tests.classroom.talk import HERE

if TYPE_CHECKING:
    from collections.abc import Callable

_CHUNK_BYTES = 65536


class RecordingProxy:
    """A TCP port that forwards everything to another port and back, until it is closed.

    Args:
        target: The other port, of this machine.
        change: Takes the bytes for the other port, and returns what is sent instead.
    """

    def __init__(self, target: int, change: Callable[[bytes], bytes] = bytes) -> None:
        self._target = target
        self._change = change
        self._server = socket.create_server((HERE, 0))
        self._open = [self._server]
        self._threads: list[threading.Thread] = []
        self.came = bytearray()  #: all bytes from the other port
        self.went = bytearray()  #: all bytes to the other port, before they are changed
        self.port = int(self._server.getsockname()[1])  #: to dial
        self._start(self._accept)

    def _start(self, work: Callable[[], None]) -> None:
        self._threads.append(threading.Thread(target=work, daemon=True))
        self._threads[-1].start()

    def _accept(self) -> None:
        with contextlib.suppress(OSError):  # it was closed
            while True:
                near, _ = self._server.accept()
                far = socket.create_connection((HERE, self._target))
                self._open += [near, far]
                self._start(partial(self._carry, near, far, self.went, self._change))
                self._start(partial(self._carry, far, near, self.came, bytes))

    @staticmethod
    def _carry(
        source: socket.socket,
        target: socket.socket,
        memory: bytearray,
        change: Callable[[bytes], bytes],
    ) -> None:
        with contextlib.suppress(OSError):  # either side has closed the connection
            while chunk := source.recv(_CHUNK_BYTES):
                memory += chunk
                target.sendall(change(chunk))
            target.shutdown(socket.SHUT_WR)

    def cut(self) -> None:
        """Break all connections that are open now."""
        for connection in self._open[1:]:
            with contextlib.suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Close all connections."""
        for connection in self._open:
            with contextlib.suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
            connection.close()
        for thread in self._threads:
            thread.join(5)
