"""Tests that text of other programs is text on every panel, and never HTML or a script."""

from __future__ import annotations

from typing import TYPE_CHECKING
from urllib.parse import quote

import pytest

from tests.kiosk import start_kiosk

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Page

    from tests.conftest import Start
    from tests.web.conftest import Server, Visit

#: HTML that would run a script when it is shown, a template of Vue, and one of JavaScript.
EVIL = "<img src=zz onerror=hit=1><script>hit=1</script>{{hit=1}}</script>`${hit=1}`"
#: Text that would end a property of an element, and begin another one that runs as a script.
QUOTED = '" :zz="hit=1" "'
#: What EVIL would leave on the page if it were HTML.
TRACES = "img[src=zz], [onerror]"
SCRIPTS = "() => [...document.scripts].filter(one => one.textContent === 'hit=1').length"


@pytest.fixture
def kiosk(start: Start, tmp_path: Path, server: Server) -> Server:
    start_kiosk(start, tmp_path / "far", EVIL)
    return server


def check(page: Page, window: Visit) -> None:
    """Check that nothing of EVIL became part of the page, ran, or was loaded."""
    assert page.locator(TRACES).count() == 0, page.url
    assert page.evaluate(SCRIPTS) == 0, page.url
    assert page.evaluate("typeof hit") == "undefined", page.url
    assert not [url for url in window.requests if url.endswith("/zz")]


def test_fields_of_messages_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/topics?topic=/menu")
    expect(page.locator(".zb-tree")).to_contain_text(EVIL)
    check(page, window)


def test_log_lines_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/console")
    # The server also has the lines of tests before.
    expect(page.locator(".zb-log tr", has_text=EVIL).first).to_be_visible()
    check(page, window)


def test_parameters_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/parameters?node=/kiosk")
    greeting = page.locator(".zb-parameter[data-name=greeting]")
    expect(greeting).to_contain_text(EVIL)  # its description
    field = page.get_by_label("greeting", exact=True)
    expect(field).to_have_value(EVIL)
    field.fill("hello")
    page.keyboard.press("Enter")
    expect(page.get_by_text("rejected").or_(greeting)).to_contain_text(EVIL)
    check(page, window)


def test_names_of_parameters_with_quotes_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/parameters?node=/kiosk")
    expect(page.get_by_label(QUOTED, exact=True)).to_be_visible()
    check(page, window)


def test_services_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/services?service=/order")
    page.get_by_role("button", name="Call").click()
    expect(page.locator(".zb-message")).to_contain_text(EVIL)
    check(page, window)
    page.get_by_label("dish", exact=True).fill("fail")
    page.get_by_role("button", name="Call").click()
    expect(page.locator(".zb-message")).to_contain_text(f"/order: {EVIL}")
    check(page, window)


def test_actions_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/actions?action=/boil")
    page.get_by_role("button", name="Send").click()
    expect(page.locator(".zb-side")).to_contain_text(EVIL)
    check(page, window)


def test_command_lines_of_processes_are_text(kiosk: Server, page: Page, window: Visit) -> None:
    page.goto(f"{kiosk.address}/processes")
    row = page.locator(".zb-list tbody tr").filter(has_text="/kiosk")
    row.click()
    expect(page.locator(".zb-side")).to_contain_text(EVIL)
    check(page, window)


def test_claimed_names_are_not_shown(kiosk: Server, page: Page, window: Visit) -> None:
    for panel in ("topics", "graph", "plot?curve=/chat"):
        page.goto(f"{kiosk.address}/{panel}")
        expect(page.get_by_text("/chat").first, panel).to_be_attached()
        check(page, window)


def test_addresses_are_text(server: Server, page: Page, window: Visit) -> None:
    for query in (
        "topics?topic=", "graph?nodes=", "graph?topics=", "plot?curve=", "services?service=",
        "actions?action=", "parameters?node=", "console?text=", "console?node=", "turtle?turtle=",
        "processes?process=", "class?student=", "frames?frame=",
        "pictures?topics=", "diagnostics?status=", "diagnostics?topic=", "launch?process=",
        "layout?layout=",
    ):  # fmt: skip
        page.goto(f"{server.address}/{query}{quote('/' + EVIL)}")
        page.wait_for_function("window.socket?.connected")
        expect(page.locator(".zb-main"), query).to_be_visible()
        check(page, window)


def test_a_topic_of_pictures_with_quotes_is_text(server: Server, page: Page, window: Visit) -> None:
    page.goto(f"{server.address}/pictures?topics={quote(f'/a{QUOTED}', safe='')}")
    expect(page.get_by_label(f"Pause /a{QUOTED}", exact=True)).to_be_visible()
    check(page, window)


def test_a_curve_with_quotes_is_text(server: Server, page: Page, window: Visit) -> None:
    page.goto(f"{server.address}/plot?curve={quote(f'/a{QUOTED}.x', safe='')}")
    expect(page.get_by_label(f"Remove /a{QUOTED}.x", exact=True)).to_be_visible()
    check(page, window)
