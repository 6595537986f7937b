"""Listener of a server with https, which answers browsers that forgot the `s` of `https`."""

from __future__ import annotations

import selectors
import socket
import threading
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

_TLS_HANDSHAKE = b"\x16"  # the first byte of each connection with TLS
#: Browsers open connections in advance. One that says nothing for this time is closed.
_SILENCE_S = 15.0
_MOST_SILENT = 256
_FULL_S = 0.1
_TEXT = "This page needs https: write https:// in place of http:// in its address.\n"
_HINT = (
    "HTTP/1.1 400 Bad Request\r\nContent-Type: text/plain; charset=utf-8\r\n"
    f"Content-Length: {len(_TEXT)}\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n{_TEXT}"
).encode()


class HttpsListener:
    """Thread that accepts connections, until `close`.

    It looks at the first byte of each connection, without reading it. asyncio cannot do this: its
    servers read the first bytes before they can choose.

    Args:
        listener: A listening socket. `close` does not close it.
        accept: Takes each connection that begins with TLS. It is called in the thread.
    """

    def __init__(self, listener: socket.socket, accept: Callable[[socket.socket], object]) -> None:
        self._listener, self._accept = listener, accept
        self._silent: dict[socket.socket, float] = {}  # connections without a byte, oldest first
        self._selector = selectors.DefaultSelector()
        self._waker, self._wakes = socket.socketpair()
        listener.setblocking(False)
        self._selector.register(listener, selectors.EVENT_READ)
        self._selector.register(self._wakes, selectors.EVENT_READ)
        self._thread = threading.Thread(target=self._run, name="zbot https", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Accept no more connections. A second call does nothing."""
        self._waker.close()
        self._thread.join()

    def _run(self) -> None:
        while True:
            timeout_s = _SILENCE_S if self._silent else None
            for key, _ in self._selector.select(timeout_s):
                if key.fileobj is self._wakes:
                    self._end()
                    return
                if key.fileobj is self._listener:
                    self._take()
                elif isinstance(key.fileobj, socket.socket):
                    self._look(key.fileobj)
            self._close_silent()

    def _take(self) -> None:
        try:
            connection, _ = self._listener.accept()
        except (BlockingIOError, ConnectionError):
            return  # the browser has given up
        except OSError:  # the process has too many open files: the connection waits for one
            time.sleep(_FULL_S)
            return
        connection.setblocking(False)
        self._silent[connection] = time.monotonic()
        self._selector.register(connection, selectors.EVENT_READ)

    def _look(self, connection: socket.socket) -> None:
        try:
            first = connection.recv(1, socket.MSG_PEEK)
        except BlockingIOError:
            return
        except OSError:
            first = b""
        self._forget(connection)
        if first == _TLS_HANDSHAKE:
            self._accept(connection)
            return
        if first:
            _tell(connection)
        connection.close()

    def _forget(self, connection: socket.socket) -> None:
        self._silent.pop(connection, None)
        self._selector.unregister(connection)

    def _close_silent(self) -> None:
        now_s = time.monotonic()
        too_many = len(self._silent) - _MOST_SILENT
        for number, (connection, since_s) in enumerate(list(self._silent.items())):
            if number >= too_many and now_s - since_s < _SILENCE_S:
                return
            self._forget(connection)
            connection.close()

    def _end(self) -> None:
        for connection in list(self._silent):
            self._forget(connection)
            connection.close()
        self._selector.close()
        self._wakes.close()


def _tell(connection: socket.socket) -> None:
    """Answer a request without TLS."""
    try:
        connection.recv(2**16)  # unread bytes would reset the connection before the answer arrives
        connection.send(_HINT)
        connection.shutdown(socket.SHUT_WR)
    except OSError:
        return  # the browser has gone
