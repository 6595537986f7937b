"""Guard of the server for Foxglove: a proxy that refuses unknown websites and wrong tokens.

It also limits what each client may use, and publishes for the clients (`connection.py`).

Any website in the user's browser can open a websocket to 127.0.0.1, and the server of
`foxglove-sdk` accepts every websocket. So this server listens on a random address that websites
cannot guess. Clients connect to the guard, which checks each request before it connects the client
to the server.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import re
import socket
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from zbot.memory import give_back_freed_memory
from zbot.observer.serving.address import TOKEN_PARAMETER, other_machine, without_token
from zbot.observer.serving.client_budget import Clients, OverBudgetError
from zbot.observer.serving.own_names import OwnNames
from zbot.observer.serving.proxy import HeadReader
from zbot.observer.serving.request import Answer, RequestError, parsed
from zbot.web.foxglove.connection import Connection, Streams

if TYPE_CHECKING:
    from collections.abc import Callable, Collection

    from zbot.web.foxglove.publishing import Publishing

#: The web application of Foxglove.
FOXGLOVE_ORIGIN = "https://app.foxglove.dev"
#: Schemes of the origins of applications on this machine, e.g. Foxglove for the desktop. The origin
#: of a website never has one of these schemes.
_APPLICATIONS = frozenset({"app", "file", "lichtblick", "foxglove"})
_EXTENSIONS = re.compile(rb"(?im)^sec-websocket-extensions[ \t]*:.*\r\n")
_SWITCHED = re.compile(rb"HTTP/1\.1 101 ")
_THREADS = 16
_LOCAL_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})


class Guard:
    """TCP server that forwards websockets to another server of this machine.

    Args:
        host: The host that the guard listens on.
        inner: Host and port of the server behind the guard.
        token: The token that the address must contain. It is `None` for a loopback host.
        origins: Further origins whose pages may connect, e.g. `http://lab:8080`.
        publishing: Function that returns the publishers of a new client.
    """

    def __init__(
        self,
        host: str,
        inner: tuple[str, int],
        token: str | None,
        origins: Collection[str] = (),
        *,
        publishing: Callable[[], Publishing],
    ) -> None:
        self._inner = inner
        self._publishing = publishing
        self._clients = Clients()
        self._threads = ThreadPoolExecutor(_THREADS, "zbot foxglove")
        self._waiting_threads = ThreadPoolExecutor(_THREADS, "zbot foxglove types")
        self._heads = HeadReader()
        self._token = token
        self._names = OwnNames(host, has_token=token is not None)
        self._origins = frozenset({FOXGLOVE_ORIGIN, *origins})

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Check a client's request. Then serve the client until one side closes."""
        try:
            with contextlib.closing(writer):
                head = await self._heads.read(reader, writer)
                refusal = "the request is too long or has no end"
                if head is not None:
                    refusal = self.refusal(head)
                if head is None or refusal:
                    writer.write(Answer(403, refusal).head_and_body())
                    await writer.drain()
                    return
                await self._pass_on(self.without_token(head), reader, writer)
        except (OSError, asyncio.IncompleteReadError):
            return  # one of the sides has closed the connection

    def refusal(self, head: bytes) -> str:
        """Return the reason why a request is refused, or an empty text if it is accepted."""
        try:
            request = parsed(head)
        except RequestError as error:
            return str(error)
        fields = request.fields
        if request.method != "GET" or not request.is_websocket:
            return "this is no web page: open this address in Foxglove or Lichtblick"
        if fields.get("host", "") not in self._names:
            return f"{fields.get('host', '')!r} is not a name of this server"
        origin = fields.get("origin")
        if origin is not None and not self._may_come_from(origin):
            return f"pages of {origin} may not connect: allow them with --origin {origin}"
        if self._token is not None:
            given = dict(request.query).get(TOKEN_PARAMETER, "")
            if not hmac.compare_digest(given.encode(), self._token.encode()):
                return "the token is missing: use the address that `zbot foxglove` printed"
        return ""

    def _may_come_from(self, origin: str) -> bool:
        if origin in self._origins:
            return True
        try:
            parts = urlsplit(origin)
            name = (parts.hostname or "").lower()
        except ValueError:
            return False
        # A web server on this machine often serves Lichtblick.
        return parts.scheme in _APPLICATIONS or name in _LOCAL_NAMES

    @staticmethod
    def without_token(head: bytes) -> bytes:
        """Return a request without the token in its address, and without extensions."""
        line, _, rest = head.partition(b"\r\n")
        method, _, last = line.partition(b" ")
        target, _, version = last.partition(b" ")
        target = without_token(target.decode("latin-1")).encode("latin-1")
        # The guard reads all messages, so no extension may change their form, e.g. compress them.
        rest = _EXTENSIONS.sub(b"", rest)
        return b" ".join((method, target, version)) + b"\r\n" + rest

    async def _pass_on(
        self, head: bytes, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        peer = writer.get_extra_info("peername")
        machine = other_machine(peer[0] if peer else "")
        try:
            self._clients.add(machine)
        except OverBudgetError as error:
            writer.write(Answer(403, str(error)).head_and_body())
            await writer.drain()
            return
        try:
            inner_reader, inner_writer = await asyncio.open_connection(*self._inner)
            with contextlib.closing(inner_writer):
                inner_writer.write(head)
                answer = await inner_reader.readuntil(b"\r\n\r\n")
                writer.write(answer)
                if _SWITCHED.match(answer):
                    client = Streams(reader, writer)
                    server = Streams(inner_reader, inner_writer)
                    threads = self._threads, self._waiting_threads
                    await Connection(client, server, self._publishing(), *threads).run()
        finally:
            self._clients.remove(machine)
            with contextlib.suppress(RuntimeError):  # the server is ending
                self._threads.submit(give_back_freed_memory)

    def close(self) -> None:
        """Cancel all work that has not begun."""
        for threads in (self._threads, self._waiting_threads):
            threads.shutdown(wait=False, cancel_futures=True)


def free_loopback_address() -> str:
    """Return a random loopback address, which websites cannot guess.

    If the system has only one loopback address, return 127.0.0.1.
    """
    import secrets  # noqa: PLC0415 - only here

    numbers = (secrets.randbelow(254) + 1 for _ in range(3))
    candidate = ".".join(["127", *map(str, numbers)])
    with contextlib.suppress(OSError), socket.socket() as probe:
        probe.bind((candidate, 0))
        return candidate
    return "127.0.0.1"
