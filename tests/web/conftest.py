"""Fixtures for pages in the Chromium of this machine, driven by Playwright."""

from __future__ import annotations

import os
import shutil
import sys
from contextlib import ExitStack
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar
from urllib.parse import urlsplit

import pytest

from tests.conftest import Program, wait_until
from zbot.testing.domain import reserved_domain
from zbot_cli.domain.client import snapshot

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Locator, Page, ViewportSize

Value = TypeVar("Value")

_LOCAL = {"127.0.0.1", "localhost"}
ARGUMENTS = [
    "--no-sandbox",  # Chromium refuses to run as root otherwise
    "--disable-gpu",
    "--enable-unsafe-swiftshader",  # WebGL without a graphics card, for the 3D view
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]
COMMAND = ("zbot", "web", "--no-browser", "--port", "0")
ENDED_BY_CTRL_C = 130
_USUAL_SIZE: ViewportSize = {"width": 1280, "height": 720}
#: A phone, a small projector and a large screen. A panel is loaded on the first one.
SCREENS: tuple[ViewportSize, ...] = (
    {"width": 390, "height": 844},
    {"width": 1024, "height": 640},
    {"width": 1920, "height": 1080},
)
#: Long, because other tests use the cores at the same time.
PAGE_TIMEOUT_MS = 40_000


def chromium() -> str | None:
    """Return the path of this machine's Chromium or Chrome, if there is one.

    The headless shell is Chromium without its window, which needs half of the processor time.
    """
    names = ["chromium-headless-shell", "chromium", "chromium-browser"]
    names += ["google-chrome", "google-chrome-stable"]
    return next(filter(None, map(shutil.which, names)), None)


#: Parts of errors in the console that are no faults of the page.
_HARMLESS = (
    "net::ERR_CONNECTION_REFUSED",  # pages that are still open, after a test ended their server
    # viser's page, if a change comes before the element, which then has this change.
    "Tried to update non-existent component",
)


class Visit:
    """Browser window with the requests that it sent and the errors that it reported."""

    def __init__(self, browser: Browser, **options: Any) -> None:
        self.context = browser.new_context(**options)
        self.requests: list[str] = []
        self.errors: list[str] = []
        self.page = self.new_page()

    def new_page(self) -> Page:
        page = self.context.new_page()
        page.set_default_timeout(PAGE_TIMEOUT_MS)
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("websocket", lambda socket: self.requests.append(socket.url))
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("console", self._note)
        go_to = page.goto

        def go_to_and_connect(*words: Any, **more: Any) -> Any:
            # What a test does before the page is connected may happen in another order.
            response = go_to(*words, **more)
            page.wait_for_function("window.did_handshake !== false", polling=50)
            return response

        page.goto = go_to_and_connect  # type: ignore[method-assign]
        return page

    def _note(self, message: Any) -> None:
        print(f"the page's console: {message.type}: {message.text}")  # pytest shows it on a failure
        if message.type == "error" and not any(part in message.text for part in _HARMLESS):
            self.errors.append(message.text)

    @property
    def foreign_requests(self) -> list[str]:
        hosts = ((url, urlsplit(url)) for url in self.requests)
        return [url for url, parts in hosts if parts.hostname and parts.hostname not in _LOCAL]

    def new_errors(self) -> list[str]:
        """Return the errors and the requests to other machines since the last call."""
        found = self.errors + self.foreign_requests
        self.errors.clear()
        self.requests.clear()
        return found


class Server:
    """Running `zbot web`."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.address = program.wait_for("zbot web: ", 30).partition("zbot web: ")[2].rstrip("/")

    def stop(self) -> int:
        return self.program.stop(timeout=15)


class SharedBrowser:
    """Browser, window, domain and servers of successive tests, as they start slowly."""

    def __init__(self) -> None:
        self._ends = ExitStack()
        self._servers: dict[tuple[str, ...], Server] = {}

    @cached_property
    def browser(self) -> Browser:
        pytest.importorskip("nicegui", reason='the page needs NiceGUI: pip install "zbot[web]"')
        playwright = pytest.importorskip("playwright.sync_api", reason="no Playwright is installed")
        path = chromium()
        if path is None:
            pytest.skip("there is no Chromium on this machine")
        playwright.expect.set_options(timeout=PAGE_TIMEOUT_MS)
        driver = self._ends.enter_context(playwright.sync_playwright())
        browser: Browser = driver.chromium.launch(executable_path=path, args=ARGUMENTS)
        self._ends.callback(browser.close)
        return browser

    @cached_property
    def window(self) -> Visit:
        """Return one window for all tests: a new one needs a second to load the page."""
        window = Visit(self.browser)
        self._ends.callback(window.context.close)
        return window

    @cached_property
    def domain(self) -> int:
        return self._ends.enter_context(reserved_domain())

    @property
    def has_servers(self) -> bool:
        return bool(self._servers)

    def server(self, folder: Path, *words: str) -> Server:
        """Return the `zbot web` with these options, in the environment's domain."""
        if words not in self._servers:
            command = [sys.executable, "-m", "zbot_cli", *COMMAND[1:], *words]
            server = Server(Program(command, folder, {**os.environ}))
            self._ends.callback(_stop_with_ctrl_c, server)
            self._servers[words] = server
        return self._servers[words]

    def close(self) -> None:
        self._ends.close()


def _stop_with_ctrl_c(server: Server) -> None:
    assert server.stop() == ENDED_BY_CTRL_C


_SHARED_BROWSER = pytest.StashKey[SharedBrowser]()


# Not at the end of the session: while Playwright runs, asyncio.run() fails in its thread.
@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    """Close the shared browser after the last of successive tests that use it."""
    try:
        return (yield)
    finally:
        if "shared_browser" not in getattr(nextitem, "fixturenames", ()):
            _close_shared_browser(item.session)


def pytest_sessionfinish(session: pytest.Session) -> None:
    _close_shared_browser(session)  # for a session that stops before its last test


def _close_shared_browser(session: pytest.Session) -> None:
    shared_browser = session.stash.get(_SHARED_BROWSER, None)
    if shared_browser is not None:
        del session.stash[_SHARED_BROWSER]
        shared_browser.close()


@pytest.fixture
def shared_browser(request: pytest.FixtureRequest) -> SharedBrowser:
    return request.session.stash.setdefault(_SHARED_BROWSER, SharedBrowser())


@pytest.fixture
def browser(shared_browser: SharedBrowser) -> Browser:
    return shared_browser.browser


@pytest.fixture
def window(shared_browser: SharedBrowser) -> Visit:
    return shared_browser.window


@pytest.fixture
def domain(
    shared_browser: SharedBrowser, request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch
) -> int:
    """Return the shared domain, after the nodes of the previous test have left it."""
    monkeypatch.setenv("ZBOT_DOMAIN_ID", str(shared_browser.domain))
    if shared_browser.has_servers and not wait_until(has_servers_only, 10):
        left = snapshot().nodes
        _close_shared_browser(request.session)  # the next tests get other servers
        pytest.fail(f"the test before this one has left nodes: {left}")
    return shared_browser.domain


def has_servers_only() -> bool:
    """Return whether all nodes of the domain are those of servers."""
    nodes = snapshot().nodes
    servers = {node.zid for node in nodes if node.node.startswith("_zbot_web")}
    return {node.zid for node in nodes} == servers


@pytest.fixture
def visit(browser: Browser, start: object) -> Iterator[Callable[..., Visit]]:  # noqa: ARG001
    """Return a function that opens a new browser window; it closes before programs end."""
    visits: list[Visit] = []

    def open_window(**options: Any) -> Visit:
        visits.append(Visit(browser, **options))
        return visits[-1]

    yield open_window
    for past in visits:
        past.context.close()
    for past in visits:
        assert past.new_errors() == []


@pytest.fixture
def page(window: Visit, start: object) -> Iterator[Page]:  # noqa: ARG001 - programs end after it
    """Return the window's page; at the end, check that it sent no request to other machines."""
    yield window.page
    window.page.goto("about:blank")
    window.page.set_viewport_size(_USUAL_SIZE)
    window.page.emulate_media(color_scheme="light")
    window.page.mouse.move(0, 0)
    window.context.clear_cookies()
    assert window.new_errors() == []


@pytest.fixture
def another_page(window: Visit, page: Page) -> Iterator[Callable[[], Page]]:  # noqa: ARG001
    """Return a function that opens one more page in the window; it closes before `page`."""
    yield window.new_page
    for other in window.context.pages[1:]:
        other.close()


@pytest.fixture
def serve(browser: Browser, start: Callable[..., Program]) -> Callable[..., Server]:  # noqa: ARG001
    """Return a function that starts `zbot web` in the test's domain, on a free port."""

    def run(*words: str) -> Server:
        return Server(start(*COMMAND, *words))

    return run


@pytest.fixture
def server(
    browser: Browser,  # noqa: ARG001 - skips without a browser
    domain: int,  # noqa: ARG001 - by the environment
    shared_browser: SharedBrowser,
    tmp_path_factory: pytest.TempPathFactory,
) -> Server:
    """Return the shared `zbot web`."""
    return shared_browser.server(tmp_path_factory.getbasetemp())


@pytest.fixture
def read_only_server(
    browser: Browser,  # noqa: ARG001 - as above
    domain: int,  # noqa: ARG001
    shared_browser: SharedBrowser,
    tmp_path_factory: pytest.TempPathFactory,
) -> Server:
    """Return the shared `zbot web` whose pages are read-only."""
    return shared_browser.server(tmp_path_factory.getbasetemp(), "--read-only")


@pytest.fixture
def turtlesim(start: Callable[..., Program]) -> Program:
    program = start("zbot", "run", "turtlesim", "turtlesim_node", "--no-browser")
    program.wait_for("Spawning turtle [turtle1]")
    return program


def settled(page: Page, look: Callable[[], Value]) -> Value:
    """Return what `look` returns when that has stopped changing."""
    last = look()

    def is_still() -> bool:
        nonlocal last
        page.wait_for_timeout(400)  # longer than an animation of the page
        before, last = last, look()
        return before == last

    assert wait_until(is_still), f"this still changes: {last}"
    return last


def command(page: Page) -> Locator:
    """Return the command that does in a terminal what the panel does."""
    return page.locator(".zb-command")


def pytest_configure() -> None:
    # Without this, Playwright's driver would search for proxies and request 127.0.0.1 from them.
    os.environ.setdefault("NO_PROXY", "127.0.0.1,localhost")
