from __future__ import annotations

import csv
import io
import math
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.conftest import wait_until

from std_msgs.msg import Float64, Float64MultiArray, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Page

    from tests.conftest import Program, Spinner
    from tests.web.conftest import Server

#: All points of all curves in the browser: {name: [[time, value], ...]}
POINTS = """() => Object.fromEntries(
    [...zbot.plot.plots.values()].flatMap(plot => [...plot.curves].map(
        ([name, curve]) => [name, curve.times.map((time, at) => [time, curve.values[at]])])))"""


@pytest.fixture
def node(make_context: Callable[[], zbot.Context], spin: Callable[..., Spinner]) -> zbot.Node:
    """Return a node that publishes a sine of 1 Hz on /wave, and two numbers on /pair."""
    node = zbot.Node("robot", context=make_context())
    wave = node.create_publisher(Float64, "wave", 10)
    pair = node.create_publisher(Float64MultiArray, "pair", 10)

    def publish() -> None:
        wave.publish(Float64(data=math.sin(2 * math.pi * time.time())))
        pair.publish(Float64MultiArray(data=[1.0, -2.0]))

    node.create_timer(0.02, publish)
    spin(node)
    return node


def points(page: Page, name: str, count: int) -> list[tuple[float, float]]:
    """Return a curve's points when there are at least this many."""
    page.wait_for_function(f"({POINTS})()[{name!r}]?.length >= {count}")
    return [(time_s, value) for time_s, value in page.evaluate(POINTS)[name]]


@pytest.mark.usefixtures("node")
def test_plot_follows_a_sine(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/wave.data")
    came = points(page, "/wave.data", 100)
    # A busy machine may pause between value and stamp: most points must fit, not all.
    errors = sorted(abs(value - math.sin(2 * math.pi * at)) for at, value in came)
    assert errors[len(errors) // 2] < 0.2
    assert max(value for _, value in came) > 0.9
    assert min(value for _, value in came) < -0.9
    # The curve is as high as the plot.
    page.wait_for_function(
        """() => [...document.querySelectorAll('.zb-chart path')].some(
            path => path.getBBox().height > 200 && path.getAttribute('fill') === 'none')"""
    )


def test_curves_are_added_and_removed_by_hand(server: Server, page: Page, node: zbot.Node) -> None:
    page.goto(f"{server.address}/plot")
    page.fill("input[aria-label=Curve]", "/pair.data[1]")
    page.press("input[aria-label=Curve]", "Enter")
    assert points(page, "/pair.data[1]", 5)[0][1] == -2.0
    page.fill("input[aria-label=Curve]", "wave/data")
    page.click("button:has-text('Add')")
    points(page, "/wave.data", 5)
    assert page.inner_text(".zb-command") == "zbot plot '/pair.data[1]' /wave.data"
    page.click("button[aria-label='Remove /pair.data[1]']")
    page.wait_for_function(f"!({POINTS})()['/pair.data[1]']")
    assert wait_until(lambda: node.count_subscribers("/pair") == 0, 10)
    page.reload()
    points(page, "/wave.data", 5)


@pytest.mark.usefixtures("node")
def test_topic_without_a_field_shows_all_its_numbers(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/pair")
    points(page, "/pair.data[0]", 5)
    points(page, "/pair.data[1]", 5)


def test_curve_without_points_shows_the_reason(server: Server, page: Page, node: zbot.Node) -> None:
    node.create_publisher(String, "text", 10)
    page.goto(f"{server.address}/plot?curve=/nothing.x,/wave.dada")
    page.wait_for_selector("text=no node uses /nothing yet")
    page.wait_for_selector("text=has no attribute 'dada'")
    page.fill("input[aria-label=Curve]", "/wave.data[")
    page.click("button:has-text('Add')")
    page.wait_for_selector("text=write it like pose.position.x")


@pytest.mark.usefixtures("node")
def test_pause_stops_the_drawing_and_no_point_is_lost(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/wave.data")
    points(page, "/wave.data", 20)
    page.click("button:has-text('Pause')")
    page.wait_for_selector("button:has-text('Resume')")
    drawn = page.inner_html(".zb-chart")
    count = len(page.evaluate(POINTS)["/wave.data"])
    points(page, "/wave.data", count + 30)
    assert page.inner_html(".zb-chart") == drawn
    page.click("button:has-text('Resume')")
    page.wait_for_function(
        "html => document.querySelector('.zb-chart').innerHTML !== html", arg=drawn
    )


@pytest.mark.usefixtures("node")
def test_csv_has_every_point(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/wave.data,/pair.data[0]")
    points(page, "/wave.data", 30)
    points(page, "/pair.data[0]", 30)
    with page.expect_download() as download:
        page.click("button:has-text('CSV')")
    assert download.value.suggested_filename == "plot.csv"
    text = Path(download.value.path()).read_text(encoding="utf-8")
    head, *rows = csv.reader(io.StringIO(text))
    assert head == ["time", "/wave.data", "/pair.data[0]"]
    assert len(rows) >= 60
    times = [float(row[0]) for row in rows]
    assert times == sorted(times)
    assert {row[2] for row in rows} == {"", "1"}


@pytest.mark.usefixtures("node")
def test_hidden_page_shows_all_points_when_it_returns(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/wave.data")
    points(page, "/wave.data", 10)
    pretend = """hidden => {
        Object.defineProperty(document, "hidden", {value: hidden, configurable: true});
        document.dispatchEvent(new Event("visibilitychange"));
    }"""
    page.evaluate(pretend, True)
    hidden_s = time.time()
    page.wait_for_timeout(1500)
    shown_s = time.time()
    page.evaluate(pretend, False)
    page.wait_for_function(f"({POINTS})()['/wave.data'].at(-1)[0] > {shown_s}")
    came = points(page, "/wave.data", 10)
    assert any(hidden_s + 0.5 < at < shown_s - 0.5 for at, _ in came)


@pytest.mark.usefixtures("node")
def test_zbot_plot_serves_the_plot_at_its_address(
    start: Callable[..., Program], page: Page
) -> None:
    program = start("zbot", "plot", "/wave.data", "/pair.data[1]", "--no-browser", "--port", "0")
    address = program.wait_for("zbot web: ", 30).partition("zbot web: ")[2]
    page.goto(address)
    points(page, "/wave.data", 5)
    points(page, "/pair.data[1]", 5)
