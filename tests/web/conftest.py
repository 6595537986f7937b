"""Pages in a real browser: Chromium as the machine has it, driven by Playwright."""

from __future__ import annotations

import os
import shutil
import sys
from contextlib import ExitStack
from functools import cached_property
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import pytest

from tests.conftest import Program, reserved_domain, wait_until
from zbot_cli.domain.client import snapshot

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

_LOCAL = {"127.0.0.1", "localhost"}
_ARGUMENTS = [
    "--no-sandbox",  # it refuses to run as root otherwise
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
]
COMMAND = ("zbot", "web", "--no-browser", "--port", "0")
ENDED_BY_CTRL_C = 130
#: Generous: other tests use the machine's cores at the same time.
PATIENCE_MS = 20_000


def chromium() -> str | None:
    """Return the path of this machine's Chromium or Chrome, if there is one."""
    names = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
    return next(filter(None, map(shutil.which, names)), None)


class Visit:
    """One browser window; everything that it asked for and complained about."""

    def __init__(self, browser: Browser, **options: Any) -> None:
        self.context = browser.new_context(**options)
        self.requests: list[str] = []
        self.errors: list[str] = []
        self.page = self.new_page()

    def new_page(self) -> Page:
        page = self.context.new_page()
        page.set_default_timeout(PATIENCE_MS)
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("websocket", lambda socket: self.requests.append(socket.url))
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("console", self._note)
        return page

    def _note(self, message: Any) -> None:
        # A server that a test has ended is missed by the pages that it leaves open.
        if message.type == "error" and "net::ERR_CONNECTION_REFUSED" not in message.text:
            self.errors.append(message.text)

    @property
    def foreign_requests(self) -> list[str]:
        hosts = ((url, urlsplit(url)) for url in self.requests)
        return [url for url, parts in hosts if parts.hostname and parts.hostname not in _LOCAL]

    def complaints(self) -> list[str]:
        """Return what went wrong, and what other machines were asked for, since the last call."""
        found = self.errors + self.foreign_requests
        self.errors.clear()
        self.requests.clear()
        return found


class Server:
    """A running `zbot web`."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.address = program.wait_for("zbot web: ", 30).partition("zbot web: ")[2].rstrip("/")

    def stop(self) -> int:
        return self.program.stop(timeout_s=15)


class Stage:
    """What tests in a row share, as it starts more slowly than most of them run."""

    def __init__(self) -> None:
        self._ends = ExitStack()
        self._servers: dict[tuple[str, ...], Server] = {}

    @cached_property
    def browser(self) -> Browser:
        pytest.importorskip("nicegui", reason="the page needs NiceGUI: pip install 'zbot[web]'")
        playwright = pytest.importorskip("playwright.sync_api", reason="no Playwright is installed")
        path = chromium()
        if path is None:
            pytest.skip("there is no Chromium on this machine")
        playwright.expect.set_options(timeout=PATIENCE_MS)
        driver = self._ends.enter_context(playwright.sync_playwright())
        browser: Browser = driver.chromium.launch(executable_path=path, args=_ARGUMENTS)
        self._ends.callback(browser.close)
        return browser

    @cached_property
    def window(self) -> Visit:
        """A new one would load and compile everything anew, for a second."""
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
            self._ends.callback(_end, server)
            self._servers[words] = server
        return self._servers[words]

    def close(self) -> None:
        self._ends.close()


def _end(server: Server) -> None:
    assert server.stop() == ENDED_BY_CTRL_C


_STAGE = pytest.StashKey[Stage]()


# Not for the whole session: while Playwright is there, asyncio.run() is not possible in its thread.
@pytest.hookimpl(wrapper=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> Iterator[None]:
    """Close the stage after the last of the tests in a row that use it."""
    try:
        return (yield)
    finally:
        if "stage" not in getattr(nextitem, "fixturenames", ()):
            _close_stage(item.session)


def pytest_sessionfinish(session: pytest.Session) -> None:
    _close_stage(session)  # where the session was told to stop before its last test


def _close_stage(session: pytest.Session) -> None:
    stage = session.stash.get(_STAGE, None)
    if stage is not None:
        del session.stash[_STAGE]
        stage.close()


@pytest.fixture
def stage(request: pytest.FixtureRequest) -> Stage:
    return request.session.stash.setdefault(_STAGE, Stage())


@pytest.fixture
def browser(stage: Stage) -> Browser:
    return stage.browser


@pytest.fixture
def window(stage: Stage) -> Visit:
    return stage.window


@pytest.fixture
def domain(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> int:
    """Return the domain of the stage, after whatever the last test ran has left it."""
    monkeypatch.setenv("ZBOT_DOMAIN_ID", str(stage.domain))
    if stage.has_servers:
        assert wait_until(is_quiet, 10), snapshot().nodes
    return stage.domain


def is_quiet() -> bool:
    """Return whether there are no nodes but those of servers."""
    nodes = snapshot().nodes
    servers = {node.zid for node in nodes if node.node.startswith("_zbot_web")}
    return {node.zid for node in nodes} == servers


@pytest.fixture
def visit(browser: Browser, start: object) -> Iterator[Callable[..., Visit]]:  # noqa: ARG001
    """Return a function that opens a browser window of its own; it closes before programs end."""
    visits: list[Visit] = []

    def open_window(**options: Any) -> Visit:
        visits.append(Visit(browser, **options))
        return visits[-1]

    yield open_window
    for one in visits:
        one.context.close()
    for one in visits:
        assert one.complaints() == []


@pytest.fixture
def page(window: Visit, start: object) -> Iterator[Page]:  # noqa: ARG001 - programs end after it
    """Return the window's page; at the end it must not have asked other machines for anything."""
    yield window.page
    window.page.goto("about:blank")
    window.page.mouse.move(0, 0)
    window.context.clear_cookies()
    assert window.complaints() == []


@pytest.fixture
def another_page(window: Visit, page: Page) -> Iterator[Callable[[], Page]]:  # noqa: ARG001
    """Return a function that opens one more page in the window; it ends before `page` does."""
    yield window.new_page
    for one in window.context.pages[1:]:
        one.close()


@pytest.fixture
def serve(browser: Browser, start: Callable[..., Program]) -> Callable[..., Server]:  # noqa: ARG001
    """Return a function that starts `zbot web` in the test's domain, on a free port."""

    def run(*words: str) -> Server:
        return Server(start(*COMMAND, *words))

    return run


@pytest.fixture
def server(
    browser: Browser,  # noqa: ARG001 - tells whether this machine can show pages
    domain: int,  # noqa: ARG001 - by the environment
    stage: Stage,
    tmp_path_factory: pytest.TempPathFactory,
) -> Server:
    """Return the `zbot web` of the stage."""
    return stage.server(tmp_path_factory.getbasetemp())


@pytest.fixture
def read_only_server(
    browser: Browser,  # noqa: ARG001 - as above
    domain: int,  # noqa: ARG001
    stage: Stage,
    tmp_path_factory: pytest.TempPathFactory,
) -> Server:
    """Return another one, whose pages may only look."""
    return stage.server(tmp_path_factory.getbasetemp(), "--read-only")


def pytest_configure() -> None:
    # Playwright's driver would otherwise look for proxies, and ask them for 127.0.0.1.
    os.environ.setdefault("NO_PROXY", "127.0.0.1,localhost")
