"""Server of a bundle: it sends the files of the manifest over HTTP, and nothing else."""

from __future__ import annotations

import contextlib
import shutil
import socket
import sys
from concurrent.futures import ThreadPoolExecutor
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, HTTPServer
from typing import TYPE_CHECKING, Any
from urllib.parse import unquote

from zbot.classroom.bundle import manifest
from zbot.classroom.bundle.errors import BundleError
from zbot.classroom.bundle.first_page import FILE as PAGE

if TYPE_CHECKING:
    from pathlib import Path

DEFAULT_PORT = 8100
_MOST_PORTS = 100
_AT_ONCE = 64  #: requests that are answered at the same time; more of them wait
_TIMEOUT_S = 30.0
_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".md": "text/plain; charset=utf-8",
    ".py": "text/plain; charset=utf-8",
    ".json": "application/json",
}


class BundleServer(HTTPServer):
    """Server of one bundle.

    Args:
        folder: The folder of the bundle.
        host: The address of this machine to listen on.
        port: The first port to try. The next 100 are tried if it is taken.

    Raises:
        BundleError: The folder is not a bundle, or the server cannot listen.
    """

    request_queue_size = 128
    # On Windows, this option would let a second server take over a port in use.
    allow_reuse_address = sys.platform != "win32"

    def __init__(self, folder: Path, host: str, port: int = DEFAULT_PORT) -> None:
        self.folder = folder
        self.names = frozenset({*manifest.load(folder).files, manifest.FILE})
        self._pool = ThreadPoolExecutor(_AT_ONCE, "zbot bundle")
        last = port + _MOST_PORTS if port else 0
        for candidate in range(port, last + 1):
            try:
                super().__init__((host, candidate), _Handler)
            except OSError as error:
                if candidate == last or not port:
                    reason = error.strerror or error
                    raise BundleError(f"cannot listen on {host}:{candidate}: {reason}") from error
            else:
                return

    @property
    def address(self) -> str:
        """The address of the first page."""
        return f"http://{self.server_address[0]!s}:{self.server_port}/"

    def server_bind(self) -> None:
        """Bind the socket. The base class also asks a name server, which can take long."""
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, self.allow_reuse_address)
        self.socket.bind(self.server_address)
        self.server_address = self.socket.getsockname()
        self.server_name, self.server_port = self.socket.getsockname()[:2]

    def process_request(self, request: Any, client_address: Any) -> None:
        """Answer a request in a thread of the pool."""
        self._pool.submit(self._answer, request, client_address)

    def _answer(self, request: socket.socket, client_address: Any) -> None:
        with contextlib.suppress(OSError):  # the laptop has gone
            self.finish_request(request, client_address)
        self.shutdown_request(request)

    def server_close(self) -> None:
        """Close the socket, and end after the requests that are being answered."""
        super().server_close()
        self._pool.shutdown(cancel_futures=True)


class _Handler(BaseHTTPRequestHandler):
    """Answer to one request."""

    server_version, sys_version = "zbot", ""
    timeout = _TIMEOUT_S

    def do_GET(self) -> None:
        """Send a file."""
        self._send(with_content=True)

    def do_HEAD(self) -> None:
        """Send the size of a file."""
        self._send(with_content=False)

    def _send(self, *, with_content: bool) -> None:
        bundle = self.server
        assert isinstance(bundle, BundleServer)
        name = unquote(self.path.partition("?")[0]).removeprefix("/") or PAGE
        if name.endswith("/"):
            name += PAGE
        # Only names of the manifest are served: no path leads out of the folder.
        if name not in bundle.names:
            self.send_error(HTTPStatus.NOT_FOUND)
            return
        path = bundle.folder / name
        try:
            file = path.open("rb")
        except OSError:
            self.send_error(HTTPStatus.NOT_FOUND)
            return
        with file:
            self.send_response(HTTPStatus.OK)
            self.send_header("Content-Type", _TYPES.get(path.suffix, "application/octet-stream"))
            self.send_header("Content-Length", str(path.stat().st_size))
            self.send_header("X-Content-Type-Options", "nosniff")
            self.end_headers()
            if with_content:
                shutil.copyfileobj(file, self.wfile, 1 << 18)

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 - the base class
        """Write nothing."""
