from __future__ import annotations

import threading
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from tests.web.conftest import PAGE_TIMEOUT_MS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from playwright.sync_api import Browser, Page

    from tests.web.conftest import Server

#: Attempts of a page of another site; returns the result of each.
ATTACK = """async address => {
    const socketAddress = `${address.replace("http", "ws")}/_nicegui_ws/socket.io/`;
    const socket = new Promise(done => {
        const one = new WebSocket(`${socketAddress}?EIO=4&transport=websocket`);
        one.onopen = () => done("open");
        one.onerror = () => done("refused");
    });
    const read = fetch(address).then(() => "read", () => "refused");
    const post = fetch(`${address}/_nicegui_ws/socket.io/?EIO=4&transport=polling`,
                       {method: "POST", body: "x"}).then(() => "posted", () => "refused");
    const picture = new Promise(done => {
        const image = new Image();
        image.onload = () => done("loaded");
        image.onerror = () => done("refused");
        image.src = `${address}/favicon.ico`;
    });
    return Promise.all([socket, read, post, picture]);
}"""


@contextmanager
def unsafe_page(browser: Browser, **options: Any) -> Iterator[Page]:
    """Yield a page whose errors are expected."""
    context = browser.new_context(**options)
    page = context.new_page()
    page.set_default_timeout(PAGE_TIMEOUT_MS)
    try:
        yield page
    finally:
        context.close()


@contextmanager
def another_site(html: str = "<title>evil</title>") -> Iterator[str]:
    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("content-type", "text/html")
            self.end_headers()
            self.wfile.write(html.encode())

        def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - its name
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://localhost:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()


def test_page_of_another_site_reaches_nothing(browser: Browser, server: Server) -> None:
    with another_site() as evil, unsafe_page(browser) as page:
        page.goto(evil)
        assert page.evaluate(ATTACK, server.address) == ["refused"] * 4


def test_page_cannot_be_framed(browser: Browser, server: Server) -> None:
    html = f"<iframe src='{server.address}/topics'></iframe>"
    with another_site(html) as evil, unsafe_page(browser) as page:
        page.goto(evil)
        page.wait_for_load_state("load")
        inner = page.frames[1]
        assert inner.locator(".zb-title").count() == 0


def test_link_of_another_site_opens_the_page(browser: Browser, server: Server) -> None:
    with another_site(f"<a href='{server.address}/topics'>zbot</a>") as other:  # noqa: SIM117
        with unsafe_page(browser) as page:
            page.goto(other)
            page.click("a")
            page.wait_for_selector(".zb-list")


def test_other_machines_need_the_token(browser: Browser, serve: Callable[..., Server]) -> None:
    server = serve("--host", "0.0.0.0")
    parts = urlsplit(server.address)
    assert parts.query.startswith("token=")
    bare = f"http://127.0.0.1:{parts.port}"
    with unsafe_page(browser) as page:
        answer = page.goto(f"{bare}/topics")
        assert answer is not None
        assert answer.status == 403
        assert "the token is missing" in page.inner_text("body")
        assert page.goto(f"{bare}/?token=guess").status == 403  # type: ignore[union-attr]
    with unsafe_page(browser) as page:
        page.goto(f"{bare}/topics?{parts.query}")
        page.wait_for_selector(".zb-list")
        assert "token" not in page.url
        # The socket works, and the next page needs no token.
        page.wait_for_function("window.socket?.connected")
        page.goto(f"{bare}/plot")
        page.wait_for_selector(".zb-plot")


def test_a_page_on_another_port_cannot_use_the_cookie(
    browser: Browser, serve: Callable[..., Server]
) -> None:
    parts = urlsplit(serve("--host", "0.0.0.0").address)
    bare = f"http://127.0.0.1:{parts.port}"
    with another_site() as evil, unsafe_page(browser) as page:
        page.goto(f"{bare}/topics?{parts.query}")
        page.wait_for_selector(".zb-list")
        page.goto(evil.replace("localhost", "127.0.0.1"))  # all ports of a host share cookies
        assert page.evaluate(ATTACK, bare) == ["refused"] * 4
