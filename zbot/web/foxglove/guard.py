"""Guard of the server for Foxglove: a proxy that refuses unknown websites and wrong tokens.

Any website in the user's browser can open a websocket to 127.0.0.1, and the server of
`foxglove-sdk` accepts every websocket. So this server listens on a random address that websites
cannot guess. Clients connect to the guard, which checks each request before it connects the client
to the server.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import ipaddress
import socket
from typing import TYPE_CHECKING
from urllib.parse import parse_qsl, urlencode, urlsplit

from zbot.web.page_address import TOKEN_PARAMETER

if TYPE_CHECKING:
    from collections.abc import Collection

#: The web application of Foxglove.
FOXGLOVE_ORIGIN = "https://app.foxglove.dev"
#: Schemes of the origins of applications on this machine, e.g. Foxglove for the desktop. The origin
#: of a website never has one of these schemes.
_APPLICATIONS = frozenset({"app", "file", "lichtblick", "foxglove"})
_LOCAL_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})
_MOST_BYTES = 16_384
_PATIENCE_S = 5.0
_BLOCK_BYTES = 2**18


class Guard:
    """TCP server that forwards websockets to another server of this machine.

    Args:
        host: The host that the guard listens on.
        inner: Host and port of the server behind the guard.
        token: The token that the address must contain. It is `None` for a loopback host.
        origins: Further origins whose pages may connect, e.g. `http://lab:8080`.
    """

    def __init__(
        self, host: str, inner: tuple[str, int], token: str | None, origins: Collection[str] = ()
    ) -> None:
        self._inner = inner
        self._token = token
        self._names = _LOCAL_NAMES | {host.lower()}
        if token is not None:
            # Any machine can claim these names by mDNS. With a token, this is harmless.
            self._names |= {socket.gethostname().lower(), f"{socket.gethostname().lower()}.local"}
        self._origins = frozenset({FOXGLOVE_ORIGIN, *origins})

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Check a client's request. Then copy data in both directions until one side closes."""
        try:
            with contextlib.closing(writer):
                head = await self._head(reader)
                refusal = "the request is too long or has no end" if head is None else ""
                if head is not None:
                    refusal = self.refusal(head)
                if head is None or refusal:
                    writer.write(_response(refusal))
                    await writer.drain()
                    return
                await self._pass_on(self.without_token(head), reader, writer)
        except OSError:
            return  # one of the sides has closed the connection

    @staticmethod
    async def _head(reader: asyncio.StreamReader) -> bytes | None:
        try:
            head = await asyncio.wait_for(reader.readuntil(b"\r\n\r\n"), _PATIENCE_S)
        except (asyncio.IncompleteReadError, asyncio.LimitOverrunError, asyncio.TimeoutError):
            return None
        return head if len(head) <= _MOST_BYTES else None

    def refusal(self, head: bytes) -> str:
        """Return the reason why a request is refused, or an empty text if it is accepted."""
        method, target, fields = _parsed(head)
        if method != "GET" or fields.get("upgrade", "").lower() != "websocket":
            return "this is no web page: open this address in Foxglove or Lichtblick"
        if not self._is_ours(fields.get("host", "")):
            return f"{fields.get('host', '')!r} is not a name of this server"
        origin = fields.get("origin")
        if origin is not None and not self._may_come_from(origin):
            return f"pages of {origin} may not connect: allow them with --origin {origin}"
        if self._token is not None:
            given = dict(parse_qsl(target.partition("?")[2])).get(TOKEN_PARAMETER, "")
            if not hmac.compare_digest(given.encode(), self._token.encode()):
                return "the token is missing: use the address that `zbot foxglove` printed"
        return ""

    def _is_ours(self, host: str) -> bool:
        try:
            name = (urlsplit(f"//{host}").hostname or "").lower()
        except ValueError:
            return False
        if name in self._names:
            return True
        if self._token is None:
            return False
        # With a token, all IP addresses are accepted, because the machine may get a new address.
        with contextlib.suppress(ValueError):
            ipaddress.ip_address(name)
            return True
        return False

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
        """Return a request without the token in its address."""
        line, _, rest = head.partition(b"\r\n")
        method, _, last = line.partition(b" ")
        target, _, version = last.partition(b" ")
        path, _, query = target.decode("latin-1").partition("?")
        pairs = [pair for pair in parse_qsl(query) if pair[0] != TOKEN_PARAMETER]
        path += f"?{urlencode(pairs)}" if pairs else ""
        return b" ".join((method, path.encode("latin-1"), version)) + b"\r\n" + rest

    async def _pass_on(
        self, head: bytes, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        inner_reader, inner_writer = await asyncio.open_connection(*self._inner)
        with contextlib.closing(inner_writer):
            inner_writer.write(head)
            ways = [
                asyncio.ensure_future(_copy(reader, inner_writer)),
                asyncio.ensure_future(_copy(inner_reader, writer)),
            ]
            await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
            for way in ways:
                way.cancel()
            await asyncio.gather(*ways, return_exceptions=True)


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


async def _copy(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    while data := await reader.read(_BLOCK_BYTES):
        writer.write(data)
        await writer.drain()


def _parsed(head: bytes) -> tuple[str, str, dict[str, str]]:
    """Return the method, the target and the fields of a request."""
    line, *lines = head.decode("latin-1").split("\r\n")
    method, _, rest = line.partition(" ")
    fields: dict[str, str] = {}
    for one in lines:
        name, colon, value = one.partition(":")
        if colon:
            fields[name.strip().lower()] = value.strip()
    return method, rest.partition(" ")[0], fields


def _response(reason: str) -> bytes:
    body = f"{reason}\n".encode()
    return (
        b"HTTP/1.1 403 Forbidden\r\nContent-Type: text/plain; charset=utf-8\r\n"
        b"Connection: close\r\nContent-Length: %d\r\n\r\n%b" % (len(body), body)
    )
