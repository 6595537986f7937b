"""Tests of the page on a phone and on a small projector."""

from __future__ import annotations

import shutil
from functools import partial
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.conftest import settled
from zbot.bag import Writer

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from geometry_msgs.msg import Twist
from std_msgs.msg import String

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from tests.web.conftest import Server, Visit

PHONE = {"width": 390, "height": 844}
PROJECTOR = {"width": 1024, "height": 640}
PANELS = [
    "topics",
    "plot",
    "frames",
    "turtle",
    "drive",
    "joints",
    "services",
    "actions",
    "parameters",
    "console",
    "processes",
    "bags",
]
TOPIC = "/a_robot_with_a_long_name/front_camera/image_rectified"
DRIVEN = "/a_robot_with_a_long_name/base_controller/cmd_vel"
NODE = "/the_node_that_rectifies_images"
BAG = "a_recording_of_the_front_camera_on_a_sunny_day"
#: The smallest text that people can read on a phone, in CSS pixels.
READABLE = 8

# All elements that are partly or wholly to the right of the screen.
BEYOND = """() => [...document.querySelectorAll('body *')]
    .filter((element) => element.getClientRects().length)
    .filter((element) => element.getBoundingClientRect().right > innerWidth + 1)
    .filter((element) => !element.closest('.zb-rail, .zb-graph, .q-checkbox__native'))
    .map((element) => element.outerHTML.slice(0, 80))"""
CUT = """() => [...document.querySelectorAll('.zb-list td:first-child')]
    .filter((cell) => cell.scrollWidth > cell.clientWidth).map((cell) => cell.textContent)"""
#: Rows with more than five lines: their names have too little room.
HIGH = """() => [...document.querySelectorAll('.zb-list tbody tr')]
    .filter((row) => row.getBoundingClientRect().height > 120).map((row) => row.textContent)"""

SCRIPTS = (BEYOND, CUT, HIGH)


@pytest.fixture
def node(server: Server, make_context: Callable[[], zbot.Context]) -> zbot.Node:  # noqa: ARG001
    node = zbot.Node(NODE.strip("/"), context=make_context())
    node.create_publisher(String, TOPIC, 1)
    node.create_subscription(Twist, DRIVEN, lambda _: None, 1)
    node.get_logger().info("The image is rectified. " * 20)
    return node


@pytest.fixture
def bag(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Return the name of a bag in the folder of the page."""
    path = tmp_path_factory.getbasetemp() / BAG
    with Writer(path) as writer:
        writer.write("/words", String(data="hello"), 10**9)
    yield BAG
    shutil.rmtree(path)


@pytest.mark.parametrize("size", [PHONE, PROJECTOR], ids=["phone", "projector"])
@pytest.mark.usefixtures("node")
def test_nothing_is_beyond_the_edge_and_names_are_whole(
    visit: Callable[..., Visit], server: Server, bag: str, size: dict[str, int]
) -> None:
    page = visit(viewport=size).page
    for panel in PANELS:
        page.goto(f"{server.address}/{panel}")
        if panel in {"topics", "processes", "parameters", "bags"}:
            name = bag if panel == "bags" else TOPIC if panel == "topics" else NODE
            expect(page.get_by_role("cell", name=name)).to_be_visible()
        expect(page.locator(".zb-command")).not_to_be_empty()
        assert settled(page, lambda: [page.evaluate(script) for script in SCRIPTS]) == [
            [],
            [],
            [],
        ], panel


@pytest.mark.usefixtures("node")
def test_names_in_the_graph_are_readable_on_a_phone(
    visit: Callable[..., Visit], server: Server
) -> None:
    page = visit(viewport=PHONE).page
    page.goto(f"{server.address}/graph")
    name = page.locator(".zb-graph text").filter(has_text=NODE)
    expect(name).to_be_visible()
    height = partial(name.evaluate, "one => one.getBoundingClientRect().height")
    assert settled(page, height) >= READABLE


@pytest.mark.usefixtures("node")
def test_a_log_line_has_one_row_until_it_is_touched(
    visit: Callable[..., Visit], server: Server
) -> None:
    page = visit(viewport=PHONE, has_touch=True).page
    page.goto(f"{server.address}/console")
    row = page.locator(".zb-log tr").filter(has_text="The image is rectified.").last
    expect(row).to_be_visible()

    def height() -> float:
        box = row.bounding_box()
        assert box is not None
        return box["height"]

    before = settled(page, height)
    assert before < 30
    row.tap()
    assert wait_until(lambda: height() > 2 * before)
