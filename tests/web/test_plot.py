from __future__ import annotations

import csv
import io
import math
import time
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import expect

import zbot
from tests.conftest import wait_until
from tests.web.conftest import command, settled

from geometry_msgs.msg import Twist
from std_msgs.msg import Float64, Float64MultiArray, String

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.conftest import Program, Spinner
    from tests.web.conftest import Server

#: All points of all curves in the browser: {name: [[time, value], ...]}
POINTS = """() => Object.fromEntries(
    [...zbot.plot.plots.values()].flatMap(plot => [...plot.curves].map(
        ([name, curve]) => [name, curve.times.map((time, at) => [time, curve.values[at]])])))"""

#: The points of each drawn line: [[[x, y], ...], ...]
DRAWN = """() => [...zbot.plot.plots.keys()].flatMap(id =>
    getElement(id).chart.getOption().series.map(one => one.data))"""


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
    expect(command(page)).to_have_text("zbot plot '/pair.data[1]' /wave.data")
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
    drawn = settled(page, lambda: page.inner_html(".zb-chart"))
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


@pytest.mark.usefixtures("node")
def test_fields_are_ticked_in_a_tree(server: Server, page: Page, node: zbot.Node) -> None:
    node.create_publisher(Twist, "cmd_vel", 1)
    page.goto(f"{server.address}/plot")
    page.get_by_role("button", name="Fields").click()
    menu = page.locator(".zb-fields")
    branch(menu, "/cmd_vel").locator(".q-tree__arrow").first.click()
    branch(menu, "linear").locator(".q-tree__arrow").first.click()
    box = branch(menu, "x").get_by_role("checkbox")
    box.click()
    expect(page.locator(".zb-command")).to_have_text("zbot plot /cmd_vel.linear.x")
    box.click()
    expect(page.locator(".zb-command")).to_have_text("zbot plot")
    branch(menu, "/wave").get_by_role("checkbox").click()
    expect(page.locator(".zb-command")).to_have_text("zbot plot /wave.data")
    page.keyboard.press("Escape")
    page.get_by_label("Remove /wave.data").click()
    page.get_by_role("button", name="Fields").click()
    expect(branch(menu, "/wave").get_by_role("checkbox")).not_to_be_checked()


@pytest.mark.usefixtures("node")
def test_curves_share_or_have_their_own_axis(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/wave.data,/pair.data[0]")
    points(page, "/wave.data", 10)
    page.get_by_label("Axis of /wave.data").click()
    axes = "() => [...zbot.plot.plots.keys()].map(id => getElement(id).chart.getOption().series"
    page.wait_for_function(f"({axes}.map(one => one.yAxisIndex)))()[0].join() === '1,0'")
    page.wait_for_url(
        lambda url: parse_qs(urlsplit(url).query).get("right") == ["/wave.data"],
        wait_until="commit",
    )


@pytest.mark.usefixtures("node")
def test_a_curve_is_drawn_over_another(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/plot?curve=/wave.data,/pair.data[0]")
    points(page, "/wave.data", 50)
    points(page, "/pair.data[0]", 50)
    page.get_by_label("X axis").click()
    page.get_by_role("option", name="over /wave.data", exact=True).click()
    over = f"() => {{ const [x, y] = ({DRAWN})(); return x.length === 0 && y.length > 20; }}"
    page.wait_for_function(over)  # before, both were drawn over the time
    drawn = page.evaluate(DRAWN)
    assert {y for _, y in drawn[1]} == {1.0}
    assert all(-1 <= x <= 1 for x, _ in drawn[1])
    assert max(x for x, _ in drawn[1]) > 0.5 > -0.5 > min(x for x, _ in drawn[1])
    page.reload()
    expect(page.get_by_label("X axis")).to_have_value("over /wave.data")
    page.get_by_label("Remove /wave.data").click()
    expect(page.get_by_label("X axis")).to_have_value("over time")


def branch(menu: Locator, label: str) -> Locator:
    """Return the branch of the tree with this label."""
    heading = menu.page.get_by_text(label, exact=True)
    return menu.locator(".q-tree__node-header").filter(has=heading).first
