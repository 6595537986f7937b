"""The page as an application, and the web server that runs it."""

from __future__ import annotations

import logging
from typing import TYPE_CHECKING, Any

import uvicorn
from fastapi import FastAPI
from nicegui import ui

from zbot.web.page import add_pages

if TYPE_CHECKING:
    import socket
    from collections.abc import Callable

    from zbot.web.system import System

# Who does not come back within this time has left.
_RECONNECT_S = 3.0
_LONGEST_GOODBYE_S = 1
#: Messages to a browser that NiceGUI repeats after a short loss of the connection.
_REPEATED_MESSAGES = 100


def run(
    system: System,
    listener: socket.socket,
    protect: Callable[[Any], Any],
    tell: Callable[[], None],
) -> None:
    """Serve pages until a signal ends it; only once in a process, as NiceGUI's state is global.

    Args:
        system: What pages show.
        listener: A socket that listens.
        protect: Puts something in front of the application that decides who may ask.
        tell: Called once pages can be had.
    """
    add_pages(system)
    application = FastAPI(docs_url=None, redoc_url=None, openapi_url=None)
    ui.run_with(
        application,
        title="zbot",
        dark=None,
        reconnect_timeout=_RECONNECT_S,
        message_history_length=_REPEATED_MESSAGES,
        gzip_middleware_factory=None,  # on one machine compressing costs more time than it saves
        tailwind=False,  # it would look at every change of the page again
        show_welcome_message=False,
    )
    # Its line about browsers that were still connected at the end says nothing to a user.
    logging.getLogger("uvicorn.error").setLevel(logging.CRITICAL)
    config = uvicorn.Config(
        protect(application),
        ws="wsproto",
        log_config=None,
        access_log=False,
        server_header=False,
        proxy_headers=False,
        timeout_graceful_shutdown=_LONGEST_GOODBYE_S,
    )
    _Server(config, tell).run([listener])


class _Server(uvicorn.Server):
    def __init__(self, config: uvicorn.Config, tell: Callable[[], None]) -> None:
        super().__init__(config)
        self._tell = tell

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._tell()
