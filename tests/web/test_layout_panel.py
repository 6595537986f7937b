"""Tests of panels side by side: a lesson from a file, changes with keys, and the link."""

from __future__ import annotations

import json
from functools import partial
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qs, quote, urlsplit

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.conftest import SCREENS, settled
from tests.web.test_frames_panel import BEYOND

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from playwright.sync_api import Locator, Page

    from tests.conftest import MakeContext, Start
    from tests.web.conftest import Server, Visit

LESSON = {"title": "Lesson 3", "rows": [["topics", "graph"], ["console"]]}
TOPIC = "/news"


@pytest.fixture
def lesson(tmp_path: Path) -> Path:
    path = tmp_path / "lesson.json"
    path.write_text(json.dumps(LESSON), encoding="utf-8")
    return path


def names(page: Page) -> list[list[str]]:
    """Return the names of the panels in each row."""
    script = """() => [...document.querySelectorAll('.zb-layout-row')]
        .filter((row) => row.getClientRects().length)
        .map((row) => [...row.querySelectorAll('iframe')]
            .map((one) => one.title.split(' ')[0].toLowerCase()))"""
    found: list[list[str]] = page.evaluate(script)
    return found


def arrange(page: Page, panel: str, action: str) -> None:
    """Choose an item of the menu of a tile, with the keyboard."""
    tile = page.locator(".zb-tile").filter(has=page.get_by_text(panel, exact=True)).last
    tile.get_by_role("button").press("Enter")
    page.get_by_role("menuitem", name=action).press("Enter")


def in_address(page: Page) -> Any:
    return json.loads(
        parse_qs(urlsplit(page.evaluate("location.href")).query).get("layout", ["{}"])[0]
    )


def inner(page: Page, panel: str) -> Locator:
    return page.frame_locator(f"iframe[title^='{panel} ']").locator(".zb-body")


def test_a_lesson_comes_from_a_file_and_changes_stay_in_the_browser(
    serve: Callable[..., Server], page: Page, lesson: Path, make_context: MakeContext
) -> None:
    zbot.Node("talker", context=make_context()).create_publisher(String, TOPIC, 1)
    server = serve("--layout", str(lesson))
    assert server.address.endswith("/layout")
    page.goto(server.address)
    assert wait_until(lambda: names(page) == [["topics", "graph"], ["console"]])
    expect(page.get_by_text("Lesson 3")).to_be_visible()
    expect(inner(page, "Topics")).to_contain_text(TOPIC)
    # A frame has only the panel.
    assert page.frame_locator("iframe").first.locator(".zb-rail").is_hidden()
    arrange(page, "Console", "Move up")
    assert wait_until(lambda: names(page) == [["topics", "graph", "console"]])
    arrange(page, "Topics", "Move right")
    assert wait_until(lambda: names(page) == [["graph", "topics", "console"]])
    arrange(page, "Graph", "Close")
    assert wait_until(lambda: names(page) == [["topics", "console"]])
    # What is chosen in a panel belongs to the layout.
    inner(page, "Topics").get_by_text(TOPIC, exact=True).click()
    assert wait_until(
        lambda: in_address(page).get("rows") == [[f"topics?topic={TOPIC}", "console"]]
    )
    page.goto(server.address)
    assert wait_until(lambda: names(page) == [["topics", "console"]])
    expect(inner(page, "Topics").locator(".zb-side")).to_contain_text("Published by")
    page.get_by_role("button", name="Reset").press("Enter")
    assert wait_until(lambda: names(page) == [["topics", "graph"], ["console"]])


def test_a_page_is_made_by_hand_and_shared_by_its_address(
    server: Server, page: Page, visit: Callable[..., Visit]
) -> None:
    page.goto(f"{server.address}/layout")
    expect(page.get_by_role("status")).to_contain_text("Add a panel")
    for title in ("Console", "Processes"):
        page.get_by_label("Add a panel").click()
        page.get_by_role("option", name=title).click()
    assert wait_until(lambda: names(page) == [["console", "processes"]])
    with page.expect_download() as download:
        page.get_by_role("button", name="Save").click()
    assert json.loads(download.value.path().read_text()) == {"rows": [["console", "processes"]]}
    assert wait_until(lambda: in_address(page) == {"rows": [["console", "processes"]]})
    other = visit().page
    other.goto(page.url)
    assert wait_until(lambda: names(other) == [["console", "processes"]])
    # The other browser keeps its own page.
    other.goto(f"{server.address}/layout")
    expect(other.get_by_role("status")).to_be_visible()
    assert names(other) == []
    page.evaluate("localStorage.clear()")


def test_a_wrong_address_is_explained(server: Server, page: Page) -> None:
    text = quote('{"rows": [["grahp"]]}')
    page.goto(f"{server.address}/layout?layout={text}")
    expect(page.get_by_role("status")).to_have_text(
        "This address has no layout: there is no panel 'grahp' (did you mean 'graph'?)"
    )


def test_a_wrong_file_is_explained(start: Start, lesson: Path) -> None:
    lesson.write_text('{"rows": [["grahp"]]}', encoding="utf-8")
    program = start("zbot", "web", "--no-browser", "--layout", str(lesson))
    program.wait_for("lesson.json: there is no panel 'grahp'")
    assert program.process.wait(20) == 1


def test_the_panel_fits(server: Server, page: Page) -> None:
    page.set_viewport_size(SCREENS[0])
    page.goto(f"{server.address}/layout?layout={quote(json.dumps(LESSON))}")
    assert wait_until(lambda: len(names(page)) == 2)
    expect(inner(page, "Console")).to_be_visible()
    for size in SCREENS:
        page.set_viewport_size(size)
        assert settled(page, lambda: page.evaluate(BEYOND)) == [], size
        for frame in page.frames[1:]:
            assert settled(page, partial(frame.evaluate, BEYOND)) == [], size
