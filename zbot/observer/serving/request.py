"""Request to a guard in front of a server, and the guard's own answer to it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING
from urllib.parse import parse_qsl

if TYPE_CHECKING:
    from collections.abc import Mapping

_REASONS = {
    200: "OK",
    303: "See Other",
    400: "Bad Request",
    403: "Forbidden",
    502: "Bad Gateway",
    503: "Service Unavailable",
}


class RequestError(ValueError):
    """The bytes are not the head of a request."""


@dataclass(frozen=True)
class Request:
    """Head of a request. The names of its fields have small letters."""

    method: str
    target: str
    fields: Mapping[str, str]

    @property
    def is_websocket(self) -> bool:
        """Whether the browser wants to open a websocket."""
        return self.fields.get("upgrade", "").lower() == "websocket"

    @property
    def path(self) -> str:
        """The address without the host and the query."""
        return self.target.partition("?")[0]

    @property
    def query(self) -> list[tuple[str, str]]:
        """The names and values in the address."""
        return parse_qsl(self.target.partition("?")[2])


@dataclass(frozen=True)
class Answer:
    """Answer of the guard itself, without the server behind it."""

    status: int
    text: str
    fields: tuple[tuple[str, str], ...] = ()

    def head_and_body(self) -> bytes:
        """Return the bytes of the answer."""
        body = f"{self.text}\n".encode()
        fields = (
            ("Content-Type", "text/plain; charset=utf-8"),
            ("Content-Length", str(len(body))),
            ("Connection", "close"),
            ("Cache-Control", "no-store"),
            ("X-Content-Type-Options", "nosniff"),
            ("Referrer-Policy", "no-referrer"),
            *self.fields,
        )
        lines = [f"HTTP/1.1 {self.status} {_REASONS[self.status]}", *(": ".join(f) for f in fields)]
        return "\r\n".join([*lines, "", ""]).encode("latin-1", "replace") + body


def parsed(head: bytes) -> Request:
    """Return the request with this head.

    Raises:
        RequestError: The bytes are not the head of a request of HTTP/1.1, or a field that
            guards check comes twice.
    """
    line, *lines = head.decode("latin-1").removesuffix("\r\n\r\n").split("\r\n")
    words = line.split(" ")
    if len(words) != 3 or not words[1].startswith("/") or not words[2].startswith("HTTP/1."):
        raise RequestError("the first line is not that of a request")
    fields: dict[str, str] = {}
    for header in lines:
        name, colon, value = header.partition(":")
        name = name.lower()
        if not colon or not re.fullmatch(r"[!-9;-~]+", name):
            raise RequestError("a field of the request has no name")
        if re.search(r"[\x00-\x08\x0a-\x1f]", value):
            raise RequestError(f"the field {name[:40]} has a control character")
        if name in {"host", "origin", "upgrade"} and name in fields:
            raise RequestError(f"the field {name} comes twice")
        fields[name] = value.strip()
    return Request(words[0], words[1], fields)
