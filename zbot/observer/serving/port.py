"""Ports of servers for browsers."""

from __future__ import annotations

import errno
import socket
import sys

from zbot.classroom.hub.address import own_addresses
from zbot.observer.errors import ViewerError
from zbot.observer.serving.address import ANY_HOSTS, address

DEFAULT_HOST = "127.0.0.1"
_MOST_PORTS = 100
_BACKLOG = 128


def server_error(host: str, port: int, reason: str) -> ViewerError:
    """Return the error that the server cannot listen on a host and port."""
    return ViewerError(f"cannot listen on {host}:{port}: {reason}")


def listen(host: str, port: int) -> socket.socket:
    """Return a socket that listens on a port. If the port is taken, use the next free port.

    Raises:
        ViewerError: The machine does not have the address, or the port and the next 100 are taken.
    """
    try:
        family = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0][0]
    except OSError as error:
        raise server_error(host, port, error.strerror or str(error)) from error
    last = port if port == 0 else min(port + _MOST_PORTS, 65_535)
    for candidate in range(port, last + 1):
        try:
            return _bound(family, host, candidate)
        except OSError as error:
            if error.errno not in {errno.EADDRINUSE, errno.EACCES} or candidate == last:
                raise server_error(host, candidate, error.strerror or str(error)) from error
    raise server_error(host, port, "a port is a number from 0 to 65535")


def _bound(family: int, host: str, port: int) -> socket.socket:
    listener = socket.socket(family, socket.SOCK_STREAM)
    try:
        # On Windows, SO_REUSEADDR would let a second server take over a port in use.
        option = "SO_EXCLUSIVEADDRUSE" if sys.platform == "win32" else "SO_REUSEADDR"
        listener.setsockopt(socket.SOL_SOCKET, getattr(socket, option), 1)
        listener.bind((host, port))
        listener.listen(_BACKLOG)
    except OSError:
        listener.close()
        raise
    return listener


def addresses_of(
    host: str, port: int, path: str, token: str | None, *, scheme: str = "http"
) -> list[str]:
    """Return the addresses at which browsers reach a server, one for each address of the machine.

    Args:
        host: The host that the server listens on.
        port: Its port.
        path: The path of the page.
        token: The token that the address must contain, or None.
        scheme: `http`, `https`, `ws` or `wss`.
    """
    hosts = (*own_addresses(), DEFAULT_HOST) if host in ANY_HOSTS else (host,)
    return [address(own_host, port, path, token, scheme=scheme) for own_host in hosts]
