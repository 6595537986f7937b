"""Check that the server's own pages sent a request, and that other machines have a token.

A website in the same browser can also send requests to 127.0.0.1. The header Origin of such a
request contains the website's name. With DNS rebinding (the website's name leads to 127.0.0.1), the
header Host contains the website's name.
"""

from __future__ import annotations

import hmac
import re
from typing import TYPE_CHECKING
from urllib.parse import urlencode, urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import HTTPConnection
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.websockets import WebSocketClose

from zbot.observer.serving.address import ROSBRIDGE_PATHS, TOKEN_PARAMETER
from zbot.observer.serving.own_names import OwnNames

if TYPE_CHECKING:
    from collections.abc import Collection

    from starlette.types import ASGIApp, Message, Receive, Scope, Send

# The browser enforces this policy. A page loads nothing from other sites, and no other site can
# show the page in a frame. The panel Layout shows panels in frames. The panel View shows the 3D
# view in a frame, which another port of this machine serves. unsafe-eval is needed because NiceGUI
# compiles templates in the browser.
_POLICY = (
    "default-src 'self' data: blob: 'unsafe-inline' 'unsafe-eval'; "
    "connect-src 'self' ws://{host} wss://{host}; frame-src 'self' http://{name}:*; "
    "object-src 'none'; base-uri 'none'; "
    "form-action 'self'; frame-ancestors 'self'"
)


class RequestCheck:
    """Application (ASGI) that refuses requests and websockets from pages of other servers.

    Args:
        app: The server's application (ASGI).
        host: The host that the server listens on.
        token: The token that each browser's first request must contain. It is None if the host is
            a loopback address.
        guests: Origins of other web servers. Their pages may use the websockets of rosbridge, but
            nothing else. None means that this server does not have these websockets.
    """

    def __init__(
        self, app: ASGIApp, *, host: str, token: str | None, guests: Collection[str] | None = None
    ) -> None:
        self.app = app
        self._guests = None if guests is None else frozenset(guests)
        self._names = OwnNames(host, has_token=token is not None)
        self._token = token

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request to the application, or refuse it."""
        if scope["type"] not in {"http", "websocket"}:
            await self.app(scope, receive, send)
            return
        response = self._response(HTTPConnection(scope))
        if response is not None:
            await response(scope, receive, send)
            return
        headers = MutableHeaders(scope=scope)
        # NiceGUI would build addresses from this header of proxies, but the server has no proxy.
        del headers["x-forwarded-prefix"]
        await self.app(scope, receive, _with_policy(send, headers["host"]))

    def _response(self, request: HTTPConnection) -> ASGIApp | None:
        """Return a refusal or a redirection, or None if the application may answer the request."""
        is_page = request.scope["type"] == "http"
        is_rosbridge = not is_page and request.scope["path"] in ROSBRIDGE_PATHS
        guests = (is_rosbridge and self._guests) or frozenset()
        origin = request.headers.get("origin")
        if origin is not None and _netloc(origin) is None:
            return _refused(f"{origin!r} is not an origin", 400, is_page=is_page)
        reason = self._refusal(request.headers, guests, is_secure=_is_secure(request))
        if reason is None and self._token is not None and not self._has_cookie(request):
            is_right = self._matches(request.query_params.get(TOKEN_PARAMETER, ""))
            if is_page and is_right:
                return self._redirection(request)
            # Programs without a browser have no cookies, so the address of their websocket contains
            # the token.
            if self._guests is None or not (is_rosbridge and is_right):
                reason = "the token is missing: open the address that `zbot web` printed"
        if reason is None:
            return None
        return _refused(reason, 403, is_page=is_page)

    def _refusal(self, headers: Headers, guests: frozenset[str], *, is_secure: bool) -> str | None:
        host = headers.get("host", "")
        if host not in self._names:
            return f"{host!r} is not a name of this server: open the address that it printed"
        origin = headers.get("origin")
        if origin in guests:
            return None
        # With https, a page of the same host and port without https is another site's: anybody in
        # the network could have changed it.
        is_unsafe = is_secure and origin is not None and not origin.startswith("https://")
        if origin is not None and (_netloc(origin) != host or is_unsafe):
            return f"pages of {origin} may not send requests to zbot"
        # A link on another site may open the page. Other requests from that site are refused.
        if headers.get("sec-fetch-site", "none") in {"cross-site", "same-site"}:
            is_visit = headers.get("sec-fetch-dest") == "document"
            if not is_visit:
                return "pages of other sites may not send requests to zbot"
        return None

    def _has_cookie(self, request: HTTPConnection) -> bool:
        return self._matches(request.cookies.get(_cookie_name(request), ""))

    def _redirection(self, request: HTTPConnection) -> Response:
        """Set the cookie, and redirect the browser to the same address without the token."""
        pairs = request.query_params.multi_items()
        query = urlencode([pair for pair in pairs if pair[0] != TOKEN_PARAMETER])
        # If the target began with two slashes, the browser would go to another server.
        target = "/" + request.scope["path"].lstrip("/") + (f"?{query}" if query else "")
        headers = {"referrer-policy": "no-referrer", "cache-control": "no-store"}
        response = RedirectResponse(target, 303, headers)
        token = str(self._token)
        response.set_cookie(
            _cookie_name(request), token, httponly=True, samesite="lax", secure=_is_secure(request)
        )
        return response

    def _matches(self, given: str) -> bool:
        return hmac.compare_digest(given.encode(), str(self._token).encode())


def _refused(reason: str, status: int, *, is_page: bool) -> ASGIApp:
    if is_page:
        return PlainTextResponse(f"{status}: {reason}\n", status, {"cache-control": "no-store"})
    return WebSocketClose(1008, reason[:100])


def _netloc(origin: str) -> str | None:
    """Return the host and port of an origin, or None if the origin is not a URL."""
    try:
        return urlsplit(origin).netloc
    except ValueError:
        return None


def _is_secure(request: HTTPConnection) -> bool:
    return request.scope.get("scheme") in {"https", "wss"}


def _cookie_name(request: HTTPConnection) -> str:
    # All ports of a host share cookies. The port in the name separates two servers' cookies.
    return f"zbot_{request.scope['server'][1]}"


def _with_policy(send: Send, host: str) -> Send:
    async def send_with_policy(message: Message) -> None:
        if message["type"] == "http.response.start":
            message.setdefault("headers", [])
            headers = MutableHeaders(scope=message)
            name = host.rpartition(":")[0] if re.search(r":\d+\Z", host) else host
            headers["content-security-policy"] = _POLICY.format(host=host, name=name)
            headers["x-content-type-options"] = "nosniff"
            headers["referrer-policy"] = "no-referrer"
        await send(message)

    return send_with_policy
