"""Test of the diagnostics panel in a browser."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

import zbot
from tests.web.conftest import SCREENS, command, settled
from tests.web.test_frames_panel import BEYOND

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue

if TYPE_CHECKING:
    from playwright.sync_api import Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server

EVIL = "<img src=zz onerror=hit=1>"


class Robot:
    """Node with two motors. The left one gets warm when its test says so."""

    def __init__(self, node: zbot.Node) -> None:
        self.level = b"\0"
        self.publisher = node.create_publisher(DiagnosticArray, "/diagnostics", 10)
        self.timer = node.create_timer(0.2, self.publish)

    def publish(self) -> None:
        left = DiagnosticStatus(name="/motors/left", level=self.level, message="36 °C")
        left.values = [KeyValue(key="current", value=EVIL)]
        right = DiagnosticStatus(name="/motors/right", level=b"\1", message="worn")
        self.publisher.publish(DiagnosticArray(status=[left, right]))


@pytest.fixture
def robot(server: Server, make_context: MakeContext, spin: Spin) -> Robot:  # noqa: ARG001
    node = zbot.Node("robot", context=make_context())
    robot = Robot(node)
    spin(node)
    return robot


def names(page: Page) -> list[str]:
    return page.locator(".zb-list tbody td:first-child").all_inner_texts()


def test_the_worst_is_first_and_its_history_is_kept(
    robot: Robot, server: Server, page: Page
) -> None:
    page.goto(f"{server.address}/diagnostics")
    rows = page.locator(".zb-list tbody tr")
    expect(rows).to_have_count(3)
    assert names(page) == ["motors", "right", "left"]
    expect(page.get_by_role("status")).to_have_text("1 warning")
    expect(command(page)).to_have_text("zbot topic echo /diagnostics")
    robot.level = b"\2"
    expect(page.get_by_role("status")).to_have_text("1 error, 1 warning")
    expect(rows.nth(1)).to_contain_text("left")
    rows.nth(1).focus()
    page.keyboard.press("Enter")
    side = page.locator(".zb-side")
    expect(side).to_contain_text("current")
    expect(side.get_by_text(EVIL)).to_be_visible()  # as text
    expect(side.locator("tr").filter(has_text="36 °C")).to_have_count(2)  # OK and ERROR
    assert "status=motors" in page.url
    robot.timer.cancel()
    expect(page.get_by_role("status")).to_have_text("2 stale")
    page.get_by_text("Only problems").click()
    expect(rows).to_have_count(3)


@pytest.mark.usefixtures("robot")
def test_the_panel_fits(server: Server, page: Page) -> None:
    page.set_viewport_size(SCREENS[0])
    page.goto(f"{server.address}/diagnostics?status=motors/left")
    expect(page.locator(".zb-side")).to_contain_text("current")
    expect(command(page)).to_have_text("zbot topic echo /diagnostics")
    for size in SCREENS:
        page.set_viewport_size(size)
        assert settled(page, lambda: page.evaluate(BEYOND)) == [], size
