"""Tests of the parameters panel: sliders, refused values, and values of other programs."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.cli.command import zbot
from tests.web.conftest import command

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.conftest import Program, Start
    from tests.web.conftest import Server


@pytest.fixture
def demo(start: Start, server: Server, page: Page) -> Page:
    start("zbot", "run", "parameter_demo").wait_for("drives")
    page.goto(f"{server.address}/parameters")
    page.locator(".zb-list tr[data-key='/parameter_demo']").click()
    expect(field(page, "speed")).to_have_value("0.5")
    return page


def field(page: Page, name: str) -> Locator:
    return page.get_by_label(name, exact=True)


def entry(page: Page, name: str) -> Locator:
    return page.locator(f".zb-parameter[data-name='{name}']")


def test_a_slider_changes_the_background_of_the_turtles(
    turtlesim: Program, server: Server, page: Page, another_page: Callable[[], Page]
) -> None:
    assert turtlesim.process.poll() is None
    turtles = another_page()
    turtles.goto(f"{server.address}/turtle")
    expect(turtles.locator(".zb-stage")).to_have_css("background-color", "rgb(69, 86, 255)")
    page.goto(f"{server.address}/parameters?node=/turtlesim")
    slider = page.get_by_label("background_r slider")
    box = slider.bounding_box()
    assert box is not None
    slider.click(position={"x": box["width"] - 1, "y": box["height"] / 2})
    expect(turtles.locator(".zb-stage")).to_have_css(
        "background-color", re.compile(r"rgb\(25[3-5], 86, 255\)")
    )
    value = field(page, "background_r").input_value()
    expect(command(page)).to_have_text(f"zbot param set /turtlesim background_r {value}")


def test_parameters_show_their_descriptions(demo: Page) -> None:
    expect(entry(demo, "speed")).to_contain_text("Speed in m/s")
    expect(entry(demo, "speed")).to_contain_text("0 to 2")
    expect(entry(demo, "wheel.radius")).to_contain_text("read-only")
    expect(entry(demo, "wheel.radius")).to_contain_text("0.05")
    expect(field(demo, "wheel.radius")).to_have_count(0)


def test_a_refused_value_is_reset_with_the_reason(demo: Page) -> None:
    field(demo, "speed").fill("5")
    demo.keyboard.press("Enter")
    expect(entry(demo, "speed")).to_contain_text("out of range")
    expect(field(demo, "speed")).to_have_value("0.5")
    field(demo, "driver").fill("")
    demo.keyboard.press("Enter")
    expect(entry(demo, "driver")).to_contain_text("a driver needs a name")
    expect(field(demo, "driver")).to_have_value("Ada")
    field(demo, "laps").fill("many")
    demo.keyboard.press("Enter")
    expect(entry(demo, "laps")).to_contain_text("write a number, not 'many'")
    expect(field(demo, "laps")).to_have_value("3")


def test_values_set_by_other_programs_are_shown(demo: Page) -> None:
    assert zbot("param", "set", "/parameter_demo", "driver", "Grace").code == 0
    expect(field(demo, "driver")).to_have_value("Grace")
    field(demo, "driver").fill("Hedy")
    demo.keyboard.press("Enter")
    expect(command(demo)).to_have_text("zbot param set /parameter_demo driver Hedy")
    expect(field(demo, "driver")).to_have_value("Hedy")
    assert zbot("param", "get", "/parameter_demo", "driver").out == "String value is: Hedy\n"


def test_a_read_only_page_shows_values(start: Start, read_only_server: Server, page: Page) -> None:
    start("zbot", "run", "parameter_demo").wait_for("drives")
    page.goto(f"{read_only_server.address}/parameters?node=/parameter_demo")
    expect(entry(page, "driver")).to_contain_text("Ada")
    expect(field(page, "driver")).to_have_count(0)
