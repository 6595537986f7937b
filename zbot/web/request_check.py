"""Check that the server's own pages sent a request, and that other machines have a token.

A website in the same browser can also send requests to 127.0.0.1. The header Origin of such a
request contains the website's name. With DNS rebinding, the header Host contains it.
"""

from __future__ import annotations

import hmac
import ipaddress
import re
import socket
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qsl, urlencode, urlsplit

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable, Mapping, MutableMapping

    Scope = MutableMapping[str, Any]
    Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
    Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
    App = Callable[[Scope, Receive, Send], Awaitable[None]]

_LOCAL_NAMES = frozenset({"localhost", "127.0.0.1", "::1"})
_PARAMETER = "token"
_HOST = re.compile(r"(?P<name>\[[0-9a-fA-F:.]+\]|[\w.-]+)(:\d+)?\Z")
# The browser enforces this policy. A page loads nothing from other sites, and no other site can
# show the page in a frame. unsafe-eval is needed because NiceGUI compiles templates in the browser.
_POLICY = (
    "default-src 'self' data: blob: 'unsafe-inline' 'unsafe-eval'; "
    "connect-src 'self' ws://{host} wss://{host}; object-src 'none'; base-uri 'none'; "
    "form-action 'self'; frame-ancestors 'none'"
)


def is_loopback(host: str) -> bool:
    """Return whether only this machine can reach a host name or address."""
    if host.lower() == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


class RequestCheck:
    """Application (ASGI) that refuses requests and websockets from pages of other servers.

    Args:
        app: The server's application (ASGI).
        host: The host that the server listens on.
        token: The token that each browser's first request must contain. None on loopback.
    """

    def __init__(self, app: App, *, host: str, token: str | None) -> None:
        self.app = app
        self._names = _LOCAL_NAMES | {host.lower(), *_own_names()}
        self._token = token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request to the application, or refuse it."""
        if scope["type"] not in {"http", "websocket"}:
            await self.app(scope, receive, send)
            return
        headers = _headers(scope)
        reason = self._refusal(headers)
        if reason is None and self._token is not None and not self._has_cookie(scope, headers):
            if scope["type"] == "http" and self._has_token(scope):
                await _redirect(scope, send, self._cookie(scope))
                return
            reason = "the token is missing: open the address that `zbot web` printed"
        if reason is not None:
            await _refuse(scope, send, reason)
            return
        # NiceGUI would build addresses from this header of proxies, but the server has no proxy.
        scope["headers"] = [one for one in scope["headers"] if one[0] != b"x-forwarded-prefix"]
        await self.app(scope, receive, _with_policy(send, headers.get("host", "")))

    def _refusal(self, headers: Mapping[str, str]) -> str | None:
        host = headers.get("host", "")
        if not self._is_ours(host):
            return f"{host!r} is not a name of this server: open the address that it printed"
        origin = headers.get("origin")
        if origin is not None and urlsplit(origin).netloc != host:
            return f"pages of {origin} may not send requests to zbot"
        # A link on another site may open the page. Other requests from that site are refused.
        if headers.get("sec-fetch-site", "none") in {"cross-site", "same-site"}:
            is_visit = headers.get("sec-fetch-dest") == "document"
            if not is_visit:
                return "pages of other sites may not send requests to zbot"
        return None

    def _is_ours(self, host: str) -> bool:
        match = _HOST.match(host)
        name = match["name"].strip("[]").lower() if match else ""
        if name in self._names:
            return True
        # With a token, all IP addresses are accepted, because the machine may get a new address.
        return self._token is not None and _is_address(name)

    def _cookie_name(self, scope: Scope) -> str:
        # All ports of a host share cookies. The port in the name separates two servers' cookies.
        return f"zbot_{scope['server'][1]}"

    def _cookie(self, scope: Scope) -> str:
        return f"{self._cookie_name(scope)}={self._token}; Path=/; HttpOnly; SameSite=Lax"

    def _has_cookie(self, scope: Scope, headers: Mapping[str, str]) -> bool:
        name = self._cookie_name(scope)
        for pair in headers.get("cookie", "").split(";"):
            key, _, value = pair.strip().partition("=")
            if key == name and self._matches(value):
                return True
        return False

    def _has_token(self, scope: Scope) -> bool:
        given = dict(parse_qsl(scope["query_string"].decode("latin-1"))).get(_PARAMETER, "")
        return self._matches(given)

    def _matches(self, given: str) -> bool:
        return hmac.compare_digest(given.encode(), str(self._token).encode())


def address(host: str, port: int, path: str, token: str | None) -> str:
    """Return the address for the user's browser."""
    name = f"[{host}]" if ":" in host else host
    query = f"?{urlencode({_PARAMETER: token})}" if token else ""
    return f"http://{name}:{port}{path}{query}"


def _own_names() -> set[str]:
    name = socket.gethostname().lower()
    return {name, f"{name}.local", name.partition(".")[0]}


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def _headers(scope: Scope) -> dict[str, str]:
    return {name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]}


def _with_policy(send: Send, host: str) -> Send:
    extra = [
        (b"content-security-policy", _POLICY.format(host=host).encode("latin-1")),
        (b"x-content-type-options", b"nosniff"),
        (b"referrer-policy", b"no-referrer"),
    ]

    async def send_with_policy(message: MutableMapping[str, Any]) -> None:
        if message["type"] == "http.response.start":
            message["headers"] = [*message.get("headers", ()), *extra]
        await send(message)

    return send_with_policy


async def _redirect(scope: Scope, send: Send, cookie: str) -> None:
    """Set the cookie, and redirect the browser to the same address without the token."""
    query = scope["query_string"].decode("latin-1")
    kept = [pair for pair in parse_qsl(query, keep_blank_values=True) if pair[0] != _PARAMETER]
    target = scope["path"] + (f"?{urlencode(kept)}" if kept else "")
    # If the target began with two slashes, the browser would go to another server.
    headers = [
        (b"location", ("/" + target.lstrip("/")).encode("latin-1", "replace")),
        (b"set-cookie", cookie.encode("latin-1")),
        (b"referrer-policy", b"no-referrer"),
        (b"cache-control", b"no-store"),
    ]
    await send({"type": "http.response.start", "status": 303, "headers": headers})
    await send({"type": "http.response.body", "body": b""})


async def _refuse(scope: Scope, send: Send, reason: str) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008, "reason": reason[:100]})
        return
    headers = [(b"content-type", b"text/plain; charset=utf-8"), (b"cache-control", b"no-store")]
    await send({"type": "http.response.start", "status": 403, "headers": headers})
    await send({"type": "http.response.body", "body": f"403: {reason}\n".encode()})
