"""Tests of the frames panel: the trees, the missing link, and the reason for it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.web.conftest import settled
from zbot.tf2 import StaticTransformBroadcaster, TransformBroadcaster

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")
pytest.importorskip("axe_playwright_python", reason="axe is not installed")

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect

from geometry_msgs.msg import TransformStamped

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server, Visit

EVIL = '<img src=zz onerror=hit=1>{{hit=1}}" :zz="hit=1'
SENTENCE = "`earth` and `odom` are two trees; nobody publishes map -> odom"
COMMAND = "static_transform_publisher --frame-id map --child-frame-id odom"
#: Elements that are partly or wholly to the right of the screen.
BEYOND = """() => [...document.querySelectorAll('.zb-main *')]
    .filter((element) => element.getClientRects().length)
    .filter((element) => element.getBoundingClientRect().right > innerWidth + 1)
    .filter((element) => !element.closest('.q-checkbox__native'))
    .map((element) => element.outerHTML.slice(0, 80))"""


class Robot:
    """Node that publishes `odom -> base_link`, and fixed frames above and below it."""

    def __init__(self, node: zbot.Node) -> None:
        self.node = node
        self.moving = TransformBroadcaster(node)
        self.fixed = StaticTransformBroadcaster(node)
        self.fixed.sendTransform([self.link("earth", "map"), self.link("base_link", "laser")])
        self.timer = node.create_timer(0.05, self.drive)

    def link(self, parent: str, child: str) -> TransformStamped:
        message = TransformStamped(child_frame_id=child)
        message.header.frame_id = parent
        message.header.stamp = self.node.get_clock().now().to_msg()
        message.transform.translation.x = message.header.stamp.nanosec / 1e9
        return message

    def drive(self) -> None:
        self.moving.sendTransform(self.link("odom", "base_link"))


@pytest.fixture
def robot(server: Server, make_context: MakeContext, spin: Spin) -> Robot:  # noqa: ARG001
    node = zbot.Node("robot", context=make_context())
    robot = Robot(node)
    spin(node)
    return robot


def row(page: Page, frame: str) -> Locator:
    return page.locator(".zb-list tbody tr").filter(has=page.get_by_text(frame, exact=True))


@pytest.mark.usefixtures("robot")
def test_the_tree_shows_rates_nodes_and_the_missing_link(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/frames")
    expect(row(page, "base_link")).to_contain_text("Hz")
    expect(row(page, "base_link")).to_contain_text("old")
    expect(row(page, "base_link")).to_contain_text("/robot")
    expect(row(page, "laser")).to_contain_text("static")
    expect(row(page, "odom")).to_contain_text("missing")
    expect(row(page, "odom").locator("td").first).to_have_class("zb-mono zb-cut zb-bad")
    names = page.locator(".zb-list tbody td:first-child").all_text_contents()
    assert names == ["earth", "map", "odom", "base_link", "laser"]
    expect(page.locator(".zb-command")).to_have_text("zbot doctor --tf")
    expect(page.get_by_role("region", name="Problems")).to_contain_text(SENTENCE)
    expect(page.get_by_role("region", name="Problems")).to_contain_text(COMMAND)


def test_the_problem_goes_when_the_link_is_published(
    robot: Robot, server: Server, page: Page
) -> None:
    page.goto(f"{server.address}/frames?frame=laser")
    side = page.locator(".zb-side")
    expect(side).to_contain_text("base_link")
    expect(side).to_contain_text("The transform from laser to odom is known.")
    page.get_by_role("combobox", name="Frame").click()
    page.get_by_role("option", name="map").click()
    expect(side).to_contain_text(f"no transform from laser to map: {SENTENCE}")
    expect(side).to_contain_text(COMMAND)
    expect(page.locator(".zb-command")).to_have_text("zbot doctor --tf map laser")
    robot.fixed.sendTransform(robot.link("map", "odom"))
    expect(side).to_contain_text("The transform from laser to map is known.")
    expect(page.locator(".zb-command")).to_have_text("zbot run tf2_ros tf2_echo map laser")
    expect(page.get_by_role("region", name="Problems")).to_be_hidden()


def test_the_other_frame_is_the_top_of_the_largest_tree_until_one_is_chosen(
    robot: Robot, server: Server, page: Page
) -> None:
    robot.timer.cancel()
    page.goto(f"{server.address}/frames?frame=laser")
    other = page.get_by_role("combobox", name="Frame")
    expect(other).to_have_value("base_link")
    robot.drive()
    expect(other).to_have_value("odom")
    other.click()
    page.get_by_role("option", name="base_link").click()
    robot.fixed.sendTransform(robot.link("map", "odom"))
    robot.fixed.sendTransform(robot.link("laser", "lens"))
    expect(row(page, "lens")).to_be_visible()
    expect(other).to_have_value("base_link")


def test_a_frame_that_has_stopped_is_marked(robot: Robot, server: Server, page: Page) -> None:
    page.goto(f"{server.address}/frames")
    expect(row(page, "base_link")).to_contain_text(re.compile(r"\d\d\.\d Hz"))
    robot.timer.cancel()
    expect(row(page, "base_link")).to_contain_text("stopped")
    expect(row(page, "base_link")).to_contain_text("ago")
    expect(page.get_by_role("region", name="Problems")).to_contain_text("was last heard")


@pytest.mark.usefixtures("robot")
def test_the_keyboard_is_enough(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/frames")
    row(page, "laser").focus()
    page.keyboard.press("Enter")
    expect(page.locator(".zb-side")).to_contain_text("/tf_static")
    page.get_by_role("combobox", name="Frame").focus()
    page.keyboard.press("Enter")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    expect(page.locator(".zb-command")).to_contain_text(" laser")
    page.get_by_role("button", name="Close").focus()
    page.keyboard.press("Enter")
    expect(page.locator(".zb-command")).to_have_text("zbot doctor --tf")


def test_names_of_frames_are_text(robot: Robot, server: Server, page: Page, window: Visit) -> None:
    robot.fixed.sendTransform([robot.link("base_link", EVIL), robot.link(f"{EVIL}2", "arm")])
    page.goto(f"{server.address}/frames?frame=laser")
    expect(row(page, EVIL)).to_be_visible()
    page.get_by_role("combobox", name="Frame").click()
    page.get_by_role("option", name=EVIL, exact=True).click()
    expect(page.locator(".zb-side")).to_contain_text(f"from laser to {EVIL} is known")
    assert page.locator("img[src=zz], [onerror]").count() == 0
    assert page.evaluate("typeof hit") == "undefined"
    assert not [url for url in window.requests if url.endswith("/zz")]


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    ("width", "height", "theme"),
    [(390, 844, "dark"), (1024, 640, "light"), (1920, 1080, "dark")],
)
def test_the_panel_fits_and_axe_finds_nothing(
    visit: Callable[..., Visit], server: Server, width: int, height: int, theme: str
) -> None:
    page = visit(viewport={"width": width, "height": height}, color_scheme=theme).page
    page.goto(f"{server.address}/frames")
    expect(page.get_by_role("region", name="Problems")).to_be_visible()
    for frame in (None, "laser"):
        if frame is not None:
            row(page, frame).click()
            expect(page.locator(".zb-side")).to_contain_text("is known")
        assert settled(page, lambda: page.evaluate(BEYOND)) == []
        faults = Axe().run(page, {"exclude": [["#q-loading-bar"]]}).response["violations"]
        assert not faults, [fault["id"] for fault in faults]
