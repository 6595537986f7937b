"""Tests of the console panel: filters, pause, and thousands of lines."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

import zbot
from zbot.qos import qos_profile_rosout_default

from rcl_interfaces.msg import Log

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.web.conftest import Server


@pytest.fixture
def loggers(
    make_context: Callable[[], zbot.Context], server: Server, page: Page
) -> tuple[zbot.Node, zbot.Node]:
    context = make_context()
    nodes = zbot.Node("left", context=context), zbot.Node("right", context=context)
    page.goto(f"{server.address}/console")
    # With a line to clear, the end of the clearing is visible. A later one would take new lines.
    nodes[0].get_logger().info("before the test")
    expect(lines(page).last).to_contain_text("before the test")
    clear(page)
    expect(page.get_by_text("No log line yet.")).to_be_visible()
    return nodes


def lines(page: Page) -> Locator:
    return page.locator(".zb-log tr")


def clear(page: Page) -> None:
    page.locator("button").filter(has_text="Clear").click()


def choose(page: Page, label: str, option: str) -> None:
    page.get_by_label(label, exact=True).click()
    page.get_by_role("option", name=option, exact=True).click()


def test_lines_are_filtered_by_level_node_and_text(
    page: Page, loggers: tuple[zbot.Node, zbot.Node]
) -> None:
    left, right = loggers
    left.get_logger().info("all <b>quiet</b>")
    left.get_logger().warning("a wall ahead")
    right.get_logger().error("no battery")
    expect(lines(page)).to_have_count(3)
    expect(lines(page).first).to_contain_text("all <b>quiet</b>")
    expect(page.get_by_text("1 error")).to_be_visible()
    choose(page, "Level", "Warn")
    expect(lines(page)).to_have_count(2)
    expect(page.locator(".zb-command")).to_have_text(
        'zbot topic echo --filter "m.level >= 30" /rosout'
    )
    choose(page, "Node", "right")
    expect(lines(page)).to_have_text([re.compile("no battery")])
    choose(page, "Node", "All nodes")
    page.get_by_label("Text", exact=True).fill("WALL")
    expect(lines(page)).to_have_text([re.compile("a wall ahead")])


def test_lines_are_sorted_by_time_whenever_they_arrive(
    page: Page, loggers: tuple[zbot.Node, zbot.Node]
) -> None:
    left, right = loggers
    left.get_logger().info("now")
    expect(lines(page)).to_have_count(1)
    rosout = right.create_publisher(Log, "/rosout", qos_profile_rosout_default)
    rosout.publish(Log(level=20, name="right", msg="in 1970"))
    expect(lines(page)).to_have_text([re.compile("in 1970"), re.compile("now")])


def test_a_pause_keeps_lines_and_clear_forgets_them(
    page: Page, loggers: tuple[zbot.Node, zbot.Node]
) -> None:
    left, _ = loggers
    left.get_logger().info("one")
    expect(lines(page)).to_have_count(1)
    page.get_by_role("button", name="Pause").click()
    expect(page.get_by_role("button", name="Resume")).to_be_visible()
    left.get_logger().info("two")
    page.wait_for_timeout(400)  # long enough for a line to arrive
    expect(lines(page)).to_have_count(1)
    page.get_by_label("Text", exact=True).fill("o")
    expect(page.locator(".zb-command")).to_contain_text("'o' in")
    page.wait_for_timeout(400)
    expect(lines(page)).to_have_count(1)
    page.get_by_role("button", name="Resume").click()
    expect(lines(page)).to_have_count(2)
    clear(page)
    expect(lines(page)).to_have_count(0)
    left.get_logger().fatal("no more")
    expect(lines(page)).to_have_count(1)
    expect(page.get_by_text("1 error")).to_be_visible()


def test_thousands_of_lines_leave_a_thousand_in_the_page(
    page: Page, loggers: tuple[zbot.Node, zbot.Node]
) -> None:
    left, _ = loggers
    for number in range(5000):
        left.get_logger().info(f"line {number}")
    expect(lines(page).last).to_contain_text("line 4999")
    assert lines(page).count() <= 1000
    left.get_logger().info("and one more")
    expect(lines(page).last).to_contain_text("and one more")
