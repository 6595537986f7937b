from __future__ import annotations

import time
import urllib.error
import urllib.request
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import allowed

from std_msgs.msg import Float64

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Page

    from tests.conftest import Spinner
    from tests.web.conftest import Server, Visit


def status(address: str, **headers: str) -> int:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    try:
        with urllib.request.urlopen(urllib.request.Request(address, headers=named)) as response:
            return int(response.status)
    except urllib.error.HTTPError as error:
        error.close()
        return error.code


def test_page_names_its_panel(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(".zb-title:has-text('Topics')")
    assert page.title() == "Topics - zbot"


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "rebound.example"},
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Sec_Fetch_Site": "cross-site", "Sec_Fetch_Dest": "image"},
    ],
)
def test_requests_of_other_sites_are_refused(server: Server, headers: dict[str, str]) -> None:
    assert status(server.address) == 200
    assert status(server.address, **headers) == 403


def test_page_is_ready_within_three_seconds(
    serve: Callable[..., Server], visit: Callable[..., Visit]
) -> None:
    took: list[float] = []
    limit_s = allowed(3.0)  # one idle moment is enough
    while len(took) < 4 and min(took, default=limit_s + 1) > limit_s:
        page = visit().page
        began = time.monotonic()
        page.goto(f"{serve().address}/topics")
        page.wait_for_selector(".zb-list")
        page.wait_for_function("window.socket?.connected")
        took.append(time.monotonic() - began)
    assert min(took) <= limit_s


def test_two_hundred_topics_at_fifty_hertz_are_shown(
    server: Server,
    page: Page,
    make_context: Callable[[], zbot.Context],
    spin: Callable[..., Spinner],
) -> None:
    node = zbot.Node("many", context=make_context())
    publishers = [node.create_publisher(Float64, f"t{number}", 10) for number in range(200)]
    message = Float64()

    def publish() -> None:
        message.data += 1
        for publisher in publishers:
            publisher.publish(message)

    node.create_timer(0.02, publish)
    spin(node)
    page.goto(f"{server.address}/topics")
    page.wait_for_selector(".zb-list tr[data-key='/t199']:has-text('Hz')")
    shown = ".zb-list tr[data-key='/t199'] td:nth-child(7)"
    before = float(page.inner_text(shown))
    page.wait_for_function(
        f"before => +document.querySelector(`{shown}`).innerText > before + 20", arg=before
    )
    page.fill("input[aria-label=Filter]", "t150")  # and the page still reacts
    page.wait_for_selector(".zb-list tr[data-key='/t199']", state="detached")


def test_ctrl_c_ends_the_server_without_output(
    serve: Callable[..., Server], page: Page, window: Visit
) -> None:
    server = serve()
    page.goto(server.address)
    page.wait_for_selector(".zb-title")
    assert server.stop() == 130
    assert server.program.output.count("\n") == 0
    page.goto("about:blank")
    # The browser may report that the server has closed the websocket.
    window.errors[:] = [error for error in window.errors if "WebSocket" not in error]
