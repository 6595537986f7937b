"""Relay between a laptop and a hub that both use TLS. It has a certificate of their keystore."""

from __future__ import annotations

import contextlib
import selectors
import socket
import ssl
import threading
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from zbot.security.keystore import Identity

_CHUNK_BYTES = 65536
_PAUSE_S = 0.1


class TlsRelay:
    """A TLS port that decrypts everything, and forwards it to another TLS port, until it is closed.

    Args:
        identity: The relay's own certificate.
        host: Host of both ports.
        target: The other port.
    """

    def __init__(self, identity: Identity, host: str, target: int) -> None:
        self._target = (host, target)
        self._near = _context(identity, ssl.PROTOCOL_TLS_SERVER)
        self._far = _context(identity, ssl.PROTOCOL_TLS_CLIENT)
        self._server = socket.create_server((host, 0))
        self._server.settimeout(_PAUSE_S)
        self._over = threading.Event()
        self.went = bytearray()  #: all bytes for the other port, decrypted
        self.port = int(self._server.getsockname()[1])  #: to dial
        self._threads = [threading.Thread(target=self._accept)]
        self._threads[0].start()

    def _accept(self) -> None:
        while not self._over.is_set():
            with contextlib.suppress(TimeoutError):
                self._threads.append(
                    threading.Thread(target=self._serve, args=(self._server.accept()[0],))
                )
                self._threads[-1].start()

    def _serve(self, dialled: socket.socket) -> None:
        with contextlib.suppress(OSError), dialled:  # either side has closed the connection
            dialled.settimeout(5)
            with (
                self._near.wrap_socket(dialled, server_side=True) as near,
                socket.create_connection(self._target) as plain,
                self._far.wrap_socket(plain) as far,
            ):
                while not self._over.is_set():
                    self._carry(near, far, self.went)
                    self._carry(far, near, bytearray())

    @staticmethod
    def _carry(source: ssl.SSLSocket, target: ssl.SSLSocket, memory: bytearray) -> None:
        # One thread serves both directions, because an SSL socket is for one thread at a time.
        with selectors.DefaultSelector() as selector:
            selector.register(source, selectors.EVENT_READ)
            while source.pending() or selector.select(0.01):
                chunk = source.recv(_CHUNK_BYTES)
                if not chunk:
                    raise ConnectionError
                memory += chunk
                target.sendall(chunk)

    def close(self) -> None:
        """Close all connections."""
        self._over.set()
        for thread in self._threads:
            thread.join(10)
        self._server.close()


def _context(identity: Identity, protocol: int) -> ssl.SSLContext:
    context = ssl.SSLContext(protocol)
    context.check_hostname = False
    context.load_cert_chain(identity.certificate, identity.key)
    context.load_verify_locations(identity.authority)
    context.verify_mode = ssl.CERT_REQUIRED
    return context
