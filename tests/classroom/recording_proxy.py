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
_PAUSE_S = 0.05


class RecordingProxy:
    """A TCP port that forwards everything to another port and back, until it is closed.

    If the other port refuses, the proxy dials again: a hub may be opened again at this moment.

    Args:
        target: The other port, of this machine.
    """

    def __init__(self, target: int) -> None:
        self._target = target
        self._over = threading.Event()
        self._server = socket.create_server((HERE, 0))
        self._open = [self._server]
        self._threads: list[threading.Thread] = []
        #: takes the bytes for the other port, and returns what is sent instead
        self.change: Callable[[bytes], bytes] = bytes
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
                self._open.append(near)
                far = self._dialled()
                if far is None:
                    return
                self._open.append(far)
                self._start(partial(self._carry, near, far, self.went, self._changed))
                self._start(partial(self._carry, far, near, self.came, bytes))

    def _changed(self, chunk: bytes) -> bytes:
        return self.change(chunk)

    def _dialled(self) -> socket.socket | None:
        """Return a connection to the other port, or `None` if the proxy was closed meanwhile."""
        while not self._over.is_set():
            with contextlib.suppress(ConnectionError):
                return socket.create_connection((HERE, self._target))
            self._over.wait(_PAUSE_S)
        return None

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
        self._over.set()
        for connection in self._open:
            with contextlib.suppress(OSError):
                connection.shutdown(socket.SHUT_RDWR)
            connection.close()
        for thread in self._threads:
            thread.join(5)
