"""Web application of the live page, with the server that runs it."""

from __future__ import annotations

import asyncio
import contextlib
import logging
from typing import TYPE_CHECKING, Any

import uvicorn
from fastapi import FastAPI
from nicegui import ui
from starlette.routing import WebSocketRoute

from zbot.observer.serving.address import ROSBRIDGE_PATHS
from zbot.process.serving import serving
from zbot.web.rosbridge.bridge import Bridge
from zbot.web.rosbridge.endpoint import endpoint
from zbot.web.server.client_limits import ClientLimits, LimitedHttp
from zbot.web.server.https_listener import HttpsListener
from zbot.web.server.pages import add_pages, page_paths

if TYPE_CHECKING:
    import socket
    import ssl
    from collections.abc import Callable

    from zbot.observer.system import System
    from zbot.web.page.panel import PageServer

# If a browser does not reconnect within this time, the server deletes its page, and the browser
# loads a new one: what the user has typed or clicked since is lost. NiceGUI derives from it how
# long a browser may be silent: it asks every 8 s, and waits 4 s for an answer. With 3 s it waited
# 2 s, which a busy laptop with a large page can exceed.
_RECONNECT_S = 10.0
_SHUTDOWN_TIMEOUT_S = 1
_HANDSHAKE_S = 10.0
#: After a short loss of the connection, NiceGUI can send at most this number of messages again.
_REPEATED_MESSAGES = 100


def run(
    system: System,
    listener: socket.socket,
    protect: Callable[[Any], Any],
    on_startup: Callable[[], None],
    *,
    page_server: PageServer,
    rosbridge: bool = False,
    tls: Callable[[], ssl.SSLContext] | None = None,
) -> None:
    """Serve pages until a signal ends the server.

    Call this function only once in a process, because NiceGUI's state is global.

    Args:
        system: The running system that the pages show.
        listener: A listening socket.
        protect: Function that wraps an application (ASGI) in one that checks requests.
        on_startup: Called when the server starts to accept requests.
        page_server: What panels know of this server.
        rosbridge: Whether web programs can connect with the protocol of rosbridge.
        tls: Returns the TLS settings of a new connection, if browsers connect with https.
    """
    add_pages(system, page_server)
    application = FastAPI(docs_url=None, redoc_url=None, openapi_url=None)
    # These paths must come before NiceGUI, which answers all other paths.
    bridge = _add_rosbridge(application, system) if rosbridge else None
    ui.run_with(
        application,
        title="zbot",
        language="en-US",  # screen readers choose their voice by it
        dark=None,
        reconnect_timeout=_RECONNECT_S,
        message_history_length=_REPEATED_MESSAGES,
        gzip_middleware_factory=None,  # on one machine, sending is faster without compression
        tailwind=False,  # Tailwind would process every change of the page
        show_welcome_message=False,
    )
    # Uvicorn would log an error about browsers that are still connected at the end.
    logging.getLogger("uvicorn.error").setLevel(logging.CRITICAL)
    config = uvicorn.Config(
        protect(ClientLimits(application, page_paths())),
        http=LimitedHttp,
        ws="wsproto",
        # A message of some kilobytes could become one of many megabytes.
        ws_per_message_deflate=False,
        log_config=None,
        access_log=False,
        server_header=False,
        proxy_headers=False,
        timeout_graceful_shutdown=_SHUTDOWN_TIMEOUT_S,
    )
    try:
        with serving():
            _Server(config, on_startup, tls).run([listener])
    finally:
        if bridge is not None:
            bridge.close()


def _add_rosbridge(application: FastAPI, system: System) -> Bridge:
    bridge = Bridge(system)
    for path in ROSBRIDGE_PATHS:
        application.router.routes.append(WebSocketRoute(path, endpoint(bridge)))
    return bridge


class _Server(uvicorn.Server):
    def __init__(
        self,
        config: uvicorn.Config,
        on_startup: Callable[[], None],
        tls: Callable[[], ssl.SSLContext] | None,
    ) -> None:
        super().__init__(config)
        self._on_startup, self._tls = on_startup, tls
        self._listener: HttpsListener | None = None
        self._connecting: set[asyncio.Task[None]] = set()  # asyncio itself keeps no reference

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        if self._tls is None or sockets is None:
            await super().startup(sockets)
        else:
            await super().startup([])
            loop = asyncio.get_running_loop()
            self._listener = HttpsListener(
                sockets[0], lambda one: loop.call_soon_threadsafe(self._accept, one)
            )
        self._on_startup()

    def _accept(self, connection: socket.socket) -> None:
        task = asyncio.get_running_loop().create_task(self._connect(connection))
        self._connecting.add(task)
        task.add_done_callback(self._connecting.discard)

    async def _connect(self, connection: socket.socket) -> None:
        loop = asyncio.get_running_loop()
        settings = None if self._tls is None else self._tls()
        # A browser that does not trust the certificate ends the handshake.
        with contextlib.suppress(OSError):
            await loop.connect_accepted_socket(
                self._protocol, connection, ssl=settings, ssl_handshake_timeout=_HANDSHAKE_S
            )

    def _protocol(self) -> asyncio.Protocol:
        make: Any = self.config.http_protocol_class  # uvicorn's own servers call it like this
        made: asyncio.Protocol = make(
            config=self.config, server_state=self.server_state, app_state=self.lifespan.state
        )
        return made

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        if self._listener is not None:
            self._listener.close()
        await super().shutdown(sockets)
