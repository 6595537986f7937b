"""Tests of the 3D view inside the page: it is seen, and other sites cannot reach it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.test_security import another_site, unsafe_page
from tests.web.test_view import ATTACK, publish

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Browser, Page, ViewportSize

    from tests.conftest import MakeContext
    from tests.web.conftest import Server

SIZES: tuple[ViewportSize, ...] = (
    {"width": 390, "height": 844},
    {"width": 1024, "height": 640},
    {"width": 1920, "height": 1080},
)


def view_address(page: Page, server: Server) -> str:
    """Open the panel, and return the address in its frame, with the token."""
    page.goto(f"{server.address}/view")
    frame = page.get_by_title("3D view")
    expect(frame).to_be_visible()
    address = frame.get_attribute("src")
    assert address is not None
    return address


def test_the_view_is_seen_in_the_page_on_each_screen(
    server: Server, page: Page, make_context: MakeContext
) -> None:
    publish(zbot.Node("robot", context=make_context()))
    address = view_address(page, server)
    inner = page.frame_locator("iframe[title='3D view']")
    for size in SIZES:
        page.set_viewport_size(size)
        expect(inner.get_by_text("The fixed frame is odom.")).to_be_visible()
        box = page.get_by_title("3D view").bounding_box()
        assert box is not None
        assert box["height"] > 300
        assert box["x"] + box["width"] <= size["width"]
    assert urlsplit(address).port != urlsplit(server.address).port
    # A second panel, also after a reload, shows the same process.
    assert view_address(page, server) == address
    page.set_viewport_size({"width": 1280, "height": 720})


def test_other_sites_do_not_reach_the_view(browser: Browser, server: Server, page: Page) -> None:
    address = view_address(page, server)
    parts = urlsplit(address)
    bare = f"http://{parts.netloc}/"
    with another_site() as evil, unsafe_page(browser) as other:
        other.goto(evil)
        assert other.evaluate(ATTACK, bare) == ["refused"] * 3
    # A page of another port of this machine is of the same site, and browsers send it the cookie.
    with another_site() as evil, unsafe_page(browser) as other:
        other.goto(address)
        other.get_by_text("zbot, domain").wait_for()
        other.goto(evil.replace("localhost", "127.0.0.1"))
        assert other.evaluate(ATTACK, bare)[:2] == ["refused"] * 2
        shown: Any = [frame for frame in other.frames if frame.get_by_text("zbot, domain").count()]
        assert not shown


def test_the_view_needs_its_own_token(browser: Browser, server: Server, page: Page) -> None:
    parts = urlsplit(view_address(page, server))
    with unsafe_page(browser) as other:
        for query in ("", "?token=guess"):
            answer = other.goto(f"http://{parts.netloc}/{query}")
            assert answer is not None
            assert answer.status == 403


def test_other_machines_see_the_view_too(browser: Browser, serve: Callable[..., Server]) -> None:
    parts = urlsplit(serve("--host", "0.0.0.0").address)
    with unsafe_page(browser) as page:
        page.goto(f"http://127.0.0.1:{parts.port}/view?{parts.query}")
        inner = page.frame_locator("iframe[title='3D view']")
        expect(inner.get_by_text("zbot, domain")).to_be_visible()
        page.goto("about:blank")


def test_the_view_ends_with_the_page(
    browser: Browser,
    serve: Callable[..., Server],
    domain: int,  # noqa: ARG001
) -> None:
    server = serve()
    with unsafe_page(browser) as page:
        bare = f"http://{urlsplit(view_address(page, server)).netloc}/"
        server.stop()
        other = page.context.new_page()

        def is_refused() -> bool:
            try:
                other.goto(bare)
            except Exception as error:  # noqa: BLE001 - Playwright's own
                return "ERR_CONNECTION_REFUSED" in str(error)
            return False

        assert wait_until(is_refused, 10)
