"""Server of the live page. `serve()` runs it until Ctrl-C."""

from __future__ import annotations

import secrets
from typing import TYPE_CHECKING, Any

from zbot.observer.serving.address import address, is_loopback, origin_of
from zbot.observer.serving.browser import open_page
from zbot.observer.serving.port import DEFAULT_HOST, addresses_of, listen
from zbot.observer.system import System
from zbot.web.server.page_certificate import PageCertificate
from zbot.web.server.page_discovery import announce

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

DEFAULT_PORT = 8080


def serve(
    host: str = DEFAULT_HOST,
    port: int = DEFAULT_PORT,
    *,
    open_browser: bool = False,
    read_only: bool = False,
    start_path: str = "/",
    rosbridge: bool = False,
    guests: Sequence[str] = (),
    layout: Path | None = None,
    https: bool = False,
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
        layout: A file with the layout that the panel Layout shows at first.
        https: Whether browsers connect with TLS. The certificate is this machine's own.

    Raises:
        LayoutError: The file is not a layout.
        ViewerError: No panel has this path, or one of `guests` is not an address of a web server,
            or the server cannot listen on this host and port.
        SecurityError: The certificate for https cannot be written.
        SessionError: Zenoh cannot open a session.
    """
    # These imports take half a second, and only a running server needs them.
    from zbot.web.page.panel import PageServer  # noqa: PLC0415
    from zbot.web.panels import PANELS  # noqa: PLC0415
    from zbot.web.server.application import run  # noqa: PLC0415
    from zbot.web.server.pages import check_path, ready_made  # noqa: PLC0415
    from zbot.web.server.request_check import RequestCheck  # noqa: PLC0415

    check_path(start_path)
    shown = None if layout is None else ready_made(layout)
    origins = [origin_of(guest) for guest in guests]
    certificate = PageCertificate(host, _tell) if https else None
    scheme, socket_scheme = ("http", "ws") if certificate is None else ("https", "wss")
    listener = listen(host, port)
    token = None if is_loopback(host) else secrets.token_urlsafe(16)
    try:
        with System(read_only=read_only) as system:
            own_port = listener.getsockname()[1]
            addresses = addresses_of(host, own_port, start_path, token, scheme=scheme)
            sockets = (
                addresses_of(host, own_port, "/", token, scheme=socket_scheme) if rosbridge else []
            )

            if token is None:
                announce(system.node, address(host, own_port, "", None, scheme=scheme))

            def on_startup() -> None:
                print("\n".join(f"zbot web: {url}" for url in addresses))
                if certificate is not None:
                    print(f"certificate: SHA-256 {certificate.fingerprint}")
                print("".join(f"rosbridge: {url}\n" for url in sockets), end="", flush=True)
                if open_browser:
                    open_page(addresses[0])

            def protect(app: Any) -> RequestCheck:
                return RequestCheck(
                    app, host=host, token=token, guests=origins if rosbridge else None
                )

            run(
                system,
                listener,
                protect,
                on_startup,
                rosbridge=rosbridge,
                page_server=PageServer(host, own_port, PANELS, shown, scheme, token),
                tls=None if certificate is None else certificate.tls,
            )
    finally:
        listener.close()


def _tell(line: str) -> None:
    print(f"zbot web: {line}", flush=True)
