"""Tests of the turtle panel in a real browser."""

from __future__ import annotations

import math
import re
from functools import partial
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.conftest import wait_until
from tests.web.conftest import command, settled

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.conftest import Program, Start
    from tests.web.conftest import Server

PLACE = re.compile(r"(\w+) +x (\S+) m +y (\S+) m +theta (\S+) rad")
#: Red, green, blue and opacity of a pixel of the sheet; the position is in metres.
PIXEL = """([x, y]) => {
  const sheet = document.querySelector(".zb-sheet"), scale = sheet.width / 500;
  const [column, row] = [x * 45 * scale, (499 - y * 45) * scale];
  return [...sheet.getContext("2d").getImageData(column, row, 1, 1).data];
}"""


@pytest.fixture
def turtles(turtlesim: Program, server: Server, page: Page) -> Page:
    assert turtlesim.process.poll() is None
    page.goto(f"{server.address}/turtle")
    expect(turtle(page, "turtle1")).to_be_visible()
    return page


def turtle(page: Page, name: str) -> Locator:
    return page.locator(f'[data-turtle="{name}"]')


def place(page: Page) -> tuple[float, float, float]:
    """Return x, y and theta of the selected turtle; NaN while there is no turtle."""
    found = PLACE.search(page.locator(".zb-turtle-place").inner_text())
    if found is None:
        return math.nan, math.nan, math.nan
    return float(found[2]), float(found[3]), float(found[4])


def colour_at(page: Page, x: float, y: float) -> tuple[int, int, int] | None:
    """Return the colour at a place in metres; None where nothing was drawn."""
    r, g, b, opacity = page.evaluate(PIXEL, [x, y])
    return (r, g, b) if opacity == 255 else None


def is_blank(page: Page, x: float, y: float) -> bool:
    return colour_at(page, x, y) is None


def near(*colour: int) -> object:
    # A canvas rounds colours.
    return pytest.approx(colour, abs=3)


def wait_in_page(page: Page, condition: Callable[[], bool], timeout_s: float = 15) -> bool:
    def look() -> bool:
        page.wait_for_timeout(20)  # handles the browser's events
        return condition()

    return wait_until(look, timeout_s)


def test_an_arrow_key_drives_two_metres_and_draws_a_line(turtles: Page) -> None:
    turtles.keyboard.press("ArrowUp")
    expect(command(turtles)).to_have_text(
        'zbot topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}}"'
    )
    assert wait_in_page(turtles, lambda: place(turtles)[0] > 7.5)
    x, y, theta = place(turtles)
    assert x == pytest.approx(7.544, abs=0.1)
    assert (y, theta) == (5.54, 0.0)
    assert wait_in_page(turtles, lambda: colour_at(turtles, 6.5, 5.544) == near(179, 184, 255))
    assert colour_at(turtles, 6.5, 5.0) is None
    # As with turtle_teleop_key, so that the lesson's graph looks the same.
    assert zbot("node", "list").out == "/teleop_turtle\n/turtlesim\n"


def test_a_later_page_shows_the_drawing(turtles: Page, another_page: Callable[[], Page]) -> None:
    turtles.keyboard.press("ArrowUp")
    assert wait_in_page(turtles, lambda: place(turtles)[0] > 7.5)
    late = another_page()
    late.goto(turtles.url)
    expect(turtle(late, "turtle1")).to_be_visible()
    assert wait_in_page(late, lambda: colour_at(late, 6.5, 5.544) == near(179, 184, 255))
    turtles.get_by_role("button", name="Clear").click()
    for page in (turtles, late):
        assert wait_in_page(page, partial(is_blank, page, 6.5, 5.544))


def test_letters_turn_the_turtle_until_f_is_pressed(turtles: Page) -> None:
    turtles.keyboard.press("d")
    expect(command(turtles)).to_have_text(
        "zbot action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "
        '"{theta: 3.1416}"'
    )
    assert wait_in_page(turtles, lambda: abs(place(turtles)[2]) > 0.1)
    turtles.keyboard.press("f")  # 3 s before the turtle would stop
    turned = abs(place(turtles)[2])
    assert turned <= abs(settled(turtles, partial(place, turtles))[2]) < 3.1
    turtles.keyboard.press("g")
    assert wait_in_page(turtles, lambda: abs(place(turtles)[2]) <= 0.02)


def test_turtles_are_spawned_with_their_pens_and_killed(turtles: Page) -> None:
    turtles.get_by_label("x", exact=True).fill("3")
    turtles.get_by_label("Name of the new turtle").fill("eve")
    turtles.get_by_role("button", name="Spawn another").click()
    expect(turtle(turtles, "eve")).to_have_class(re.compile("zb-chosen"))
    expect(command(turtles)).to_have_text("zbot topic echo /eve/pose")
    turtles.get_by_label("Pen colour").fill("#ff8000")
    expect(command(turtles)).to_contain_text("zbot service call /eve/set_pen turtlesim/srv/SetPen")
    turtles.locator(".zb-stage").click(position={"x": 5, "y": 5})
    turtles.keyboard.press("ArrowUp")
    assert wait_in_page(turtles, lambda: place(turtles)[0] > 4.95)
    assert wait_in_page(turtles, lambda: colour_at(turtles, 4.0, 2.0) == near(255, 128, 0))
    turtle(turtles, "turtle1").click()
    assert wait_in_page(turtles, lambda: place(turtles)[1] == 5.54)
    turtles.get_by_role("button", name="Kill").click()
    expect(turtle(turtles, "turtle1")).to_have_count(0)
    turtles.get_by_role("button", name="Reset").click()
    expect(turtle(turtles, "turtle1")).to_be_visible()
    expect(turtle(turtles, "eve")).to_have_count(0)


def test_a_taken_name_is_reported(turtles: Page) -> None:
    turtles.get_by_label("Name of the new turtle").fill("turtle1")
    turtles.get_by_role("button", name="Spawn another").click()
    expect(turtles.get_by_text("A turtle named turtle1 already exists")).to_be_visible()


def test_the_background_can_be_chosen(turtles: Page) -> None:
    turtles.get_by_label("Background colour").fill("#305040")
    expect(turtles.locator(".zb-stage")).to_have_css("background-color", "rgb(48, 80, 64)")
    expect(command(turtles)).to_have_text(
        "zbot param set /turtlesim background_r 48 background_g 80 background_b 64"
    )


def test_two_simulators_can_be_selected(start: Start, server: Server, page: Page) -> None:
    launched = start("zbot", "launch", "turtlesim", "multisim.launch.py")
    launched.wait_for("Spawning turtle [turtle1]")
    launched.wait_for("Spawning turtle [turtle1]")
    page.goto(f"{server.address}/turtle?node=/turtlesim2/turtlesim")
    expect(turtle(page, "turtle1")).to_be_visible()
    page.keyboard.press("ArrowUp")
    expect(command(page)).to_contain_text("/turtlesim2/turtle1/cmd_vel")
    assert wait_in_page(page, lambda: place(page)[0] > 7.5)
    page.get_by_label("Simulator").click()
    page.get_by_role("option", name="/turtlesim1/turtlesim").click()
    assert wait_in_page(page, lambda: place(page)[0] == 5.54)
    assert launched.stop(timeout=15) == 0


def test_page_without_a_simulator_has_a_hint(start: Start, server: Server, page: Page) -> None:
    page.set_viewport_size({"width": 1920, "height": 1080})
    page.goto(f"{server.address}/turtle")
    hint = page.get_by_text("No turtlesim is running.")
    expect(hint).to_be_visible()
    box = hint.bounding_box()
    assert box is not None
    assert box["width"] == box["height"] > 800  # the place of the turtles fills a projector
    program = start("zbot", "run", "turtlesim", "turtlesim_node", "--no-browser")
    expect(turtle(page, "turtle1")).to_be_visible()
    program.process.kill()
    expect(page.get_by_text("No turtlesim is running.")).to_be_visible()


def test_a_read_only_page_has_no_controls(
    turtlesim: Program, read_only_server: Server, page: Page
) -> None:
    assert turtlesim.process.poll() is None
    page.goto(f"{read_only_server.address}/turtle")
    expect(turtle(page, "turtle1")).to_be_visible()
    expect(page.get_by_role("button", name="Clear")).to_have_count(0)
    page.keyboard.press("ArrowUp")
    expect(page.get_by_text("this page is read-only: driving is not possible")).to_be_visible()
