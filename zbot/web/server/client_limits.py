"""Limits of the browsers that show the live page: connections, pages and messages."""

from __future__ import annotations

import asyncio
import time
from typing import TYPE_CHECKING, Any

from nicegui import Client
from starlette.responses import PlainTextResponse
from starlette.websockets import WebSocketClose
from uvicorn.protocols.http.auto import AutoHTTPProtocol

from zbot.log import get_logger
from zbot.observer.serving.address import ROSBRIDGE_PATHS, other_machine
from zbot.observer.serving.client_budget import ClientBudget, Clients, OverBudgetError, Rate

if TYPE_CHECKING:
    from collections.abc import Collection

    from starlette.types import ASGIApp, Message, Receive, Scope, Send

#: Pages of one server. The panel Layout needs a page for each of its panels.
_MAX_PAGES = 300
_MAX_PAGES_OF_MACHINE = 100
#: Pages that one machine may open in a second. Making a page takes some 20 ms.
_PAGES_PER_S = 10
_BURST_S = 6.0
#: Pages that no browser has connected to yet. Beyond this number, the oldest is deleted.
_MAX_WAITING_PAGES = 100
#: Connections without a request. Beyond this number, the oldest is closed.
_MAX_SILENT = 100
_TRY_AGAIN_LATER = 1013


class ClientLimits:
    """Application (ASGI) that refuses what exceeds the limits of a browser.

    Args:
        app: The server's application (ASGI).
        paths: The paths of pages.
    """

    def __init__(self, app: ASGIApp, paths: Collection[str]) -> None:
        self._app = app
        self._paths = frozenset(paths)
        self._clients = Clients(_MAX_PAGES, _MAX_PAGES_OF_MACHINE)
        self._rates: dict[str, Rate] = {}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request to the application, or refuse it."""
        is_page = scope["type"] == "http" and scope["path"] in self._paths
        if is_page and not self._may_open(_machine(scope)):
            text = "too many pages are opened at the same time: try again in some seconds\n"
            await PlainTextResponse(text, 503, {"retry-after": "5"})(scope, receive, send)
        elif scope["type"] == "websocket" and scope["path"] not in ROSBRIDGE_PATHS:
            await self._serve(scope, receive, send)
        else:
            await self._app(scope, receive, send)

    def _may_open(self, machine: str) -> bool:
        waiting = [page for page in Client.instances.values() if not page.has_socket_connection]
        if len(waiting) > _MAX_WAITING_PAGES:
            waiting[0].delete()
        if len(self._rates) > _MAX_PAGES:
            self._rates.clear()
        rate = self._rates.setdefault(machine, Rate(_PAGES_PER_S, _BURST_S))
        return rate.take(1)

    async def _serve(self, scope: Scope, receive: Receive, send: Send) -> None:
        machine = _machine(scope)
        try:
            self._clients.add(machine)
        except OverBudgetError as error:
            await WebSocketClose(_TRY_AGAIN_LATER, str(error))(scope, receive, send)
            return
        try:
            await self._app(scope, _limited(receive, machine), send)
        finally:
            self._clients.remove(machine)


def _machine(scope: Scope) -> str:
    client = scope.get("client")
    return other_machine(client[0] if client else "")


def _limited(receive: Receive, machine: str) -> Receive:
    """Return a function that receives messages, and ignores those that are too many."""
    budget = ClientBudget()

    async def receive_limited() -> Message:
        while True:
            event = await receive()
            if event["type"] != "websocket.receive":
                return event
            size = len(event.get("text") or event.get("bytes") or b"")
            try:
                budget.check_message(size)
            except OverBudgetError as error:
                if str(error):
                    whose = f"the page on {machine or 'this machine'}"
                    get_logger("zbot.web").warning(f"{whose} was told: {error}")
                await asyncio.sleep(budget.refusal_pause_s(size))
            else:
                return event

    return receive_limited


class LimitedHttp(AutoHTTPProtocol):  # type: ignore[misc, valid-type] # chosen by uvicorn
    """Connection of a browser. If too many connections send no request, the oldest is closed."""

    # The attributes of both protocols of uvicorn, `httptools` and `h11`.
    connections: set[Any]
    transport: Any
    cycle: Any

    def connection_made(self, transport: Any) -> None:
        """Note a new connection. Uvicorn would keep a silent one for ever."""
        super().connection_made(transport)
        self.made_s = time.monotonic()
        found = [one for one in self.connections if isinstance(one, LimitedHttp) and one.is_silent]
        if len(found) > _MAX_SILENT:
            min(found, key=lambda one: one.made_s).transport.abort()

    @property
    def is_silent(self) -> bool:
        """Whether there was no request yet."""
        return self.cycle is None
