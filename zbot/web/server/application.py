"""Web application of the live page, with the server that runs it."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Any

import uvicorn
from fastapi import FastAPI
from nicegui import ui
from starlette.routing import WebSocketRoute

from zbot.web.page_address import ROSBRIDGE_PATHS
from zbot.web.rosbridge.bridge import Bridge
from zbot.web.rosbridge.endpoint import endpoint
from zbot.web.server.pages import add_pages

if TYPE_CHECKING:
    import socket
    from collections.abc import Callable

    from zbot.observer.system import System

# If a browser does not reconnect within this time, the server deletes its page.
_RECONNECT_S = 3.0
_SHUTDOWN_TIMEOUT_S = 1
#: After a short loss of the connection, NiceGUI can send at most this number of messages again.
_REPEATED_MESSAGES = 100


def run(
    system: System,
    listener: socket.socket,
    protect: Callable[[Any], Any],
    on_startup: Callable[[], None],
    *,
    rosbridge: bool = False,
) -> None:
    """Serve pages until a signal ends the server.

    Call this function only once in a process, because NiceGUI's state is global.

    Args:
        system: The running system that the pages show.
        listener: A listening socket.
        protect: Function that wraps an application (ASGI) in one that checks requests.
        on_startup: Called when the server starts to accept requests.
        rosbridge: Whether web programs can connect with the protocol of rosbridge.
    """
    add_pages(system)
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
        protect(application),
        ws="wsproto",
        log_config=None,
        access_log=False,
        server_header=False,
        proxy_headers=False,
        timeout_graceful_shutdown=_SHUTDOWN_TIMEOUT_S,
    )
    try:
        _Server(config, on_startup).run([listener])
    finally:
        if bridge is not None:
            bridge.close()


def _add_rosbridge(application: FastAPI, system: System) -> Bridge:
    bridge = Bridge(system)
    for path in ROSBRIDGE_PATHS:
        application.router.routes.append(WebSocketRoute(path, endpoint(bridge)))
    return bridge


class _Server(uvicorn.Server):
    def __init__(self, config: uvicorn.Config, on_startup: Callable[[], None]) -> None:
        super().__init__(config)
        self._on_startup = on_startup

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._on_startup()
