"""Web programs that others wrote, with `zbot web --rosbridge`: roslibjs in a page, and roslibpy."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import sys
import threading
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.web.conftest import PAGE_TIMEOUT_MS, Server

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from playwright.sync_api import Browser, Page

    from tests.conftest import Program

FOLDER = Path(__file__).parent / "rosbridge"
#: The name in node_modules, and the package. Most web pages use version 1.
PACKAGES = {"roslib": "roslib@2.1.0", "roslib1": "roslib1@npm:roslib@1.4.1"}
_NPM_TIMEOUT_S = 60
_ALL_CALLS_MS = 100_000


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with roslibjs from npm and with the page that uses it."""
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("there is no npm on this machine, which installs roslibjs")
    folder = tmp_path_factory.mktemp("site")
    options = ("--ignore-scripts", "--no-audit", "--no-fund", "--fetch-retries", "0")
    command = [npm, "install", "--prefix", str(folder), *options, *PACKAGES.values()]
    try:
        subprocess.run(command, check=True, capture_output=True, timeout=_NPM_TIMEOUT_S)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
        pytest.skip(f"npm cannot install roslibjs, perhaps without a network: {error}")
    for name in ("page.html", "calls.js"):
        shutil.copy(FOLDER / name, folder)
    return folder


class _Quiet(SimpleHTTPRequestHandler):
    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".mjs": "text/javascript"}

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - its name
        pass


@pytest.fixture
def web_server(site: Path) -> Iterator[str]:
    """Return the address of a web server that serves the page."""
    handler = functools.partial(_Quiet, directory=str(site))
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"http://localhost:{server.server_port}"
    server.shutdown()
    server.server_close()


@pytest.fixture
def guest_page(web_server: str, browser: Browser) -> Iterator[Page]:
    context = browser.new_context()
    page = context.new_page()
    page.set_default_timeout(_ALL_CALLS_MS)
    page.goto(f"{web_server}/page.html", timeout=PAGE_TIMEOUT_MS)
    page.wait_for_function("window.callAll !== undefined", timeout=PAGE_TIMEOUT_MS)
    yield page
    context.close()


def socket_address(server: Server) -> str:
    return server.program.wait_for("rosbridge: ").partition("rosbridge: ")[2]


@pytest.mark.parametrize("library", PACKAGES)
def test_roslibjs_in_a_page_of_another_server(
    domain: int,  # noqa: ARG001 - by the environment
    turtlesim: Program,  # noqa: ARG001 - it runs
    serve: Callable[..., Server],
    web_server: str,
    guest_page: Page,
    library: str,
) -> None:
    server = serve("--rosbridge", "--origin", web_server)
    call = "([library, url]) => window.callAll(library, url)"
    outcomes = guest_page.evaluate(call, [library, socket_address(server)])
    assert len(outcomes) > 25
    assert {name: outcome for name, outcome in outcomes.items() if outcome != "ok"} == {}


def test_pages_of_other_servers_need_the_option(
    domain: int,  # noqa: ARG001 - by the environment
    serve: Callable[..., Server],
    guest_page: Page,
) -> None:
    address = socket_address(serve("--rosbridge"))
    attempt = """url => new Promise(done => {
        const socket = new WebSocket(url);
        socket.onopen = () => done("open");
        socket.onerror = () => done("refused");
    })"""
    assert guest_page.evaluate(attempt, address) == "refused"
    assert guest_page.evaluate(attempt, f"{address}rosbridge") == "refused"
    # The server's own page may use it.
    guest_page.goto(address.replace("ws:", "http:"))
    assert guest_page.evaluate(attempt, address) == "open"


def test_roslibpy(
    domain: int,  # noqa: ARG001 - by the environment
    turtlesim: Program,  # noqa: ARG001 - it runs
    serve: Callable[..., Server],
) -> None:
    spec = find_spec("roslibpy")
    if spec is None or spec.origin is None:
        pytest.skip("roslibpy is not installed: pip install roslibpy")
    environment = {**os.environ, "PYTHONPATH": str(Path(spec.origin).parents[1])}
    address = socket_address(serve("--rosbridge"))
    program = [sys.executable, str(FOLDER / "roslibpy_calls.py"), address]
    found = subprocess.run(
        program, check=False, capture_output=True, text=True, timeout=100, env=environment
    )
    assert found.stdout.splitlines()[-1:] == ["all ok"], found.stdout + found.stderr
