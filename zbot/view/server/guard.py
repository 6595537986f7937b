"""Guard of the view: a proxy that refuses other websites and wrong tokens.

Any website in the user's browser can send requests to 127.0.0.1, and viser's server answers all of
them. So browsers connect to the guard, which checks each request before it passes it on.
"""

from __future__ import annotations

import asyncio
import contextlib
import hmac
from http.cookies import CookieError, SimpleCookie
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from zbot.observer.serving.address import TOKEN_PARAMETER, address, without_token
from zbot.observer.serving.own_names import OwnNames
from zbot.observer.serving.proxy import HeadReader, copy_both
from zbot.observer.serving.request import Answer, Request, RequestError, parsed
from zbot.view.arrangement.link import PARAMETER
from zbot.view.arrangement.rviz_writer import FILE_NAME
from zbot.view.server.software_webgl import with_script

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from concurrent.futures import Future

_FILE_PATH = f"/{FILE_NAME}"
_PATIENCE_S = 20.0
# The browser enforces this policy. The page loads nothing from other sites, and no other site can
# show the page in a frame, except zbot's live page. viser's page is one file with its scripts
# inside, and it compiles WASM.
_POLICY = (
    "default-src 'self' data: blob: 'unsafe-inline' 'unsafe-eval'; "
    "connect-src 'self' data: blob: ws://{host} wss://{host}; object-src 'none'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors {frames}"
)


class Guard:
    """TCP server that passes requests on to another server of this machine.

    Args:
        host: The host that the guard listens on.
        port: Its port.
        token: The token that a browser's first request must contain, or None for a loopback host.
        page_port: The port of the live page of this machine, which may show the view in a frame.

    Attributes:
        inner: Host and port of the server behind the guard. It is set before the first request.
        open_link: Called with the arrangement in the address of a page that a browser opens.
        rviz_file: Called when a browser asks for the arrangement as a file.
    """

    def __init__(
        self, host: str, port: int, token: str | None, page_port: int | None = None
    ) -> None:
        self.inner: tuple[str, int] = ("127.0.0.1", 0)
        self.open_link: Callable[[str], None] | None = None
        self.rviz_file: Callable[[], Future[str]] | None = None
        self._token = token
        self._page_port = page_port
        # All ports of a host share cookies. The port in the name separates two servers' cookies.
        self._cookie = f"zbot_view_{port}"
        self._names = OwnNames(host, has_token=token is not None)
        self._heads = HeadReader()
        self._own_ports: set[int] = set()

    def is_own_port(self, port: int) -> bool:
        """Return whether a connection to the server behind comes from the guard."""
        return port in self._own_ports

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """Check a browser's request, and pass it on."""
        with contextlib.suppress(OSError), contextlib.closing(writer):
            head = await self._heads.read(reader, writer)
            answer, request = self._checked(head)
            if answer is None and request is not None and request.path == _FILE_PATH:
                answer = await self._file()
            if answer is not None:
                writer.write(answer.head_and_body())
                await writer.drain()
            elif request is not None:
                self._open(request)
                await self._pass_on(request, reader, writer)

    def _checked(self, head: bytes | None) -> tuple[Answer | None, Request | None]:
        if head is None:
            return Answer(400, "the request is too long or has no end"), None
        try:
            request = parsed(head)
        except RequestError as error:
            return Answer(400, str(error)), None
        return self.answer(request), request

    def _open(self, request: Request) -> None:
        text = dict(request.query).get(PARAMETER)
        if text and self.open_link is not None and not request.is_websocket:
            self.open_link(text)

    async def _file(self) -> Answer:
        """Return the arrangement as a download."""
        if self.rviz_file is None:
            return Answer(503, "the view starts: try again")
        try:
            text = await asyncio.wait_for(asyncio.wrap_future(self.rviz_file()), _PATIENCE_S)
        except asyncio.TimeoutError:
            return Answer(503, "the view is busy: try again")
        except Exception:  # noqa: BLE001 - the view has logged it
            return Answer(503, "the view could not write this arrangement: its log says why")
        is_file = ("Content-Disposition", f'attachment; filename="{FILE_NAME}"')
        return Answer(200, text.rstrip("\n"), (is_file,))

    def answer(self, request: Request) -> Answer | None:
        """Return a refusal or a redirection, or None if the request may be passed on."""
        refusal = self._refusal(request)
        if refusal:
            return Answer(403, refusal)
        if self._token is None or self._matches(self._cookie_of(request)):
            return None
        if self._matches(dict(request.query).get(TOKEN_PARAMETER, "")) and not request.is_websocket:
            return self._redirection(request)
        return Answer(403, "the token is missing: open the address that `zbot view` printed")

    def _refusal(self, request: Request) -> str:
        fields = request.fields
        if request.method not in {"GET", "HEAD"}:
            return f"requests with {request.method[:20]} are not possible"
        host = fields.get("host", "")
        if host not in self._names:
            return f"{host!r} is not a name of this server: open the address that it printed"
        origin = fields.get("origin")
        if origin is not None and _netloc(origin) != host:
            return f"pages of {origin} may not send requests to zbot"
        # A link on another site may open the page. Other requests from that site are refused.
        site = fields.get("sec-fetch-site", "none")
        if site in {"cross-site", "same-site"}:
            is_visit = fields.get("sec-fetch-dest") == "document" or self._is_frame(fields, site)
            if request.is_websocket or not is_visit:
                return "pages of other sites may not send requests to zbot"
        return ""

    def _is_frame(self, fields: Mapping[str, str], site: str) -> bool:
        """Return whether a page of this machine shows the view in a frame.

        The browser shows the frame only if the port of that page is the right one. See `_POLICY`.
        """
        is_frame = fields.get("sec-fetch-dest") == "iframe" and site == "same-site"
        return is_frame and self._page_port is not None

    def _frames(self, host: str) -> str:
        """Return the pages that may show the view in a frame, in the words of a policy."""
        if self._page_port is None:
            return "'none'"
        return address(urlsplit(f"//{host}").hostname or "", self._page_port, "", None)

    def _cookie_of(self, request: Request) -> str:
        try:
            found = SimpleCookie(request.fields.get("cookie", "")).get(self._cookie)
        except CookieError:
            return ""
        return "" if found is None else found.value

    def _matches(self, given: str) -> bool:
        return hmac.compare_digest(given.encode("utf-8", "replace"), str(self._token).encode())

    def _redirection(self, request: Request) -> Answer:
        """Set the cookie, and redirect the browser to the same address without the token."""
        # If the target began with two slashes, the browser would go to another server.
        target = without_token("/" + request.target.lstrip("/"))
        cookie = f"{self._cookie}={self._token}; HttpOnly; Path=/; SameSite=Lax"
        return Answer(303, "", (("Location", target), ("Set-Cookie", cookie)))

    async def _pass_on(
        self, request: Request, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        try:
            inner_reader, inner_writer = await asyncio.open_connection(*self.inner)
        except OSError:
            writer.write(Answer(502, "the view has ended").head_and_body())
            return
        port = inner_writer.get_extra_info("sockname")[1]
        self._own_ports.add(port)
        try:
            with contextlib.closing(inner_writer):
                inner_writer.write(passed_on(request))
                if request.is_websocket:
                    await copy_both(reader, writer, inner_reader, inner_writer)
                    return
                # Only one request for each connection: the guard would not check a second one.
                host = request.fields["host"]
                answer = await inner_reader.readuntil(b"\r\n\r\n")
                answer, body = with_script(answer, await inner_reader.read())
                writer.write(with_policy(answer, host, self._frames(host)) + body)
                await writer.drain()
        except (asyncio.IncompleteReadError, asyncio.LimitOverrunError):
            return  # the server behind has ended
        finally:
            self._own_ports.discard(port)


def passed_on(request: Request) -> bytes:
    """Return the head of a request for the server behind: without the token and the cookie.

    The answer is neither compressed nor "not modified", because the guard adds to it.
    """
    dropped = {"cookie", "connection", "content-length", "transfer-encoding"}
    dropped |= {"accept-encoding", "if-none-match", "if-modified-since"}
    fields = {name: value for name, value in request.fields.items() if name not in dropped}
    fields["connection"] = "Upgrade" if request.is_websocket else "close"
    line = f"{request.method} {without_token(request.target)} HTTP/1.1"
    lines = [line, *(": ".join(field) for field in fields.items())]
    return "\r\n".join([*lines, "", ""]).encode("latin-1", "replace")


def with_policy(head: bytes, host: str, frames: str) -> bytes:
    """Return the head of an answer with the rules that the browser enforces.

    Args:
        head: The head.
        host: The header Host of the request.
        frames: The pages that may show the view in a frame, e.g. `'none'`.
    """
    added = (
        f"Content-Security-Policy: {_POLICY.format(host=host, frames=frames)}\r\n"
        "X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n"
        "Cache-Control: no-cache\r\n"
    )
    return head.removesuffix(b"\r\n") + added.encode("latin-1", "replace") + b"\r\n"


def _netloc(origin: str) -> str | None:
    """Return the host and port of an origin, or None if the origin is not a URL."""
    try:
        return urlsplit(origin).netloc
    except ValueError:
        return None
