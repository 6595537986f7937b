"""Server of the live page. `serve()` runs it until Ctrl-C."""

from __future__ import annotations

import errno
import secrets
import socket
import sys
from typing import TYPE_CHECKING, Any

from zbot.classroom.hub.address import own_addresses
from zbot.observer.errors import ViewerError
from zbot.observer.system import System
from zbot.web.page_address import address, is_loopback, origin_of
from zbot.web.server.browser import open_page
from zbot.web.server.page_discovery import announce

if TYPE_CHECKING:
    from collections.abc import Sequence

DEFAULT_HOST = "127.0.0.1"
DEFAULT_PORT = 8080
_MOST_PORTS = 100
_BACKLOG = 128


def server_error(host: str, port: int, reason: str) -> ViewerError:
    """Return the error that the server cannot listen on a host and port."""
    return ViewerError(f"cannot listen on {host}:{port}: {reason}")


def serve(
    host: str = DEFAULT_HOST,
    port: int = DEFAULT_PORT,
    *,
    open_browser: bool = False,
    read_only: bool = False,
    start_path: str = "/",
    rosbridge: bool = False,
    guests: Sequence[str] = (),
) -> None:
    """Serve the live page of this process's domain until a signal ends the server.

    Args:
        host: The host to listen on. Only this machine can reach a loopback address.
        port: The port. If it is taken, the server uses the next free port. 0 means any free port.
        open_browser: Whether to open the page in the user's browser.
        read_only: Whether pages can only show the system, not change it.
        start_path: The path of the first page with its query, e.g. `/plot?curve=/pose.x`.
        rosbridge: Whether web programs can connect with the protocol of rosbridge.
        guests: Addresses of web servers whose pages may also use rosbridge.

    Raises:
        ViewerError: No panel has this path, or one of `guests` is not an address of a web server,
            or the server cannot listen on this host and port.
        SessionError: Zenoh cannot open a session.
    """
    # These imports take half a second, and only a running server needs them.
    from zbot.web.server.application import run  # noqa: PLC0415
    from zbot.web.server.pages import check_path  # noqa: PLC0415
    from zbot.web.server.request_check import RequestCheck  # noqa: PLC0415

    check_path(start_path)
    origins = [origin_of(one) for one in guests]
    listener = listen(host, port)
    token = None if is_loopback(host) else secrets.token_urlsafe(16)
    try:
        with System(read_only=read_only) as system:
            own_port = listener.getsockname()[1]
            addresses = _addresses(host, own_port, start_path, token)
            sockets = _addresses(host, own_port, "/", token, scheme="ws") if rosbridge else []

            if token is None:
                announce(system.node, address(host, own_port, "", None))

            def on_startup() -> None:
                print("\n".join(f"zbot web: {one}" for one in addresses))
                print("".join(f"rosbridge: {one}\n" for one in sockets), end="", flush=True)
                if open_browser:
                    open_page(addresses[0])

            def protect(app: Any) -> RequestCheck:
                return RequestCheck(
                    app, host=host, token=token, guests=origins if rosbridge else None
                )

            run(system, listener, protect, on_startup, rosbridge=rosbridge)
    finally:
        listener.close()


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


def _addresses(
    host: str, port: int, path: str, token: str | None, *, scheme: str = "http"
) -> list[str]:
    is_any = host in {"0.0.0.0", "::"}  # noqa: S104 - it is compared, not bound
    hosts = (*own_addresses(), DEFAULT_HOST) if is_any else (host,)
    return [address(one, port, path, token, scheme=scheme) for one in hosts]
