"""Tests of the parameters panel: sliders, refused values, and values of other programs."""

from __future__ import annotations

import re
import time
from typing import TYPE_CHECKING, Any

import pytest

import zbot as zbot_library
from tests.cli.command import zbot
from tests.conftest import wait_until
from tests.web.conftest import command

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from rcl_interfaces.msg import Parameter, ParameterEvent, ParameterValue
from rcl_interfaces.srv import ListParameters, SetParameters

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Locator, Page

    from tests.conftest import MakeContext, Program, Spin, Start
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
    expect(field(page, "background_r")).to_have_value(re.compile("25[3-5]"))
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
    expect(entry(demo, "laps")).to_contain_text("not 'many'; laps is an int64: write laps: 2")
    expect(field(demo, "laps")).to_have_value("3")


def test_values_set_by_other_programs_are_shown(demo: Page) -> None:
    assert zbot("param", "set", "/parameter_demo", "driver", "Grace").code == 0
    expect(field(demo, "driver")).to_have_value("Grace")
    field(demo, "driver").fill("Hedy")
    demo.keyboard.press("Enter")
    expect(command(demo)).to_have_text("zbot param set /parameter_demo driver Hedy")
    expect(field(demo, "driver")).to_have_value("Hedy")
    assert zbot("param", "get", "/parameter_demo", "driver").out == "String value is: Hedy\n"


def test_a_node_that_was_started_again_is_shown_as_it_is_now(
    start: Start, server: Server, page: Page, another_page: Callable[[], Page]
) -> None:
    address = f"{server.address}/parameters?node=/parameter_demo"
    first = start("zbot", "run", "parameter_demo")
    first.wait_for("drives")
    page.goto(address)
    assert zbot("param", "set", "/parameter_demo", "driver", "Grace").code == 0
    expect(field(page, "driver")).to_have_value("Grace")
    first.stop()
    start("zbot", "run", "parameter_demo").wait_for("drives")
    expect(field(page, "driver")).to_have_value("Ada")
    later = another_page()
    later.goto(address)
    expect(field(later, "driver")).to_have_value("Ada")
    # The events of the former node are not shown after the load.
    assert zbot("param", "set", "/parameter_demo", "laps", "7").code == 0
    expect(field(later, "laps")).to_have_value("7")
    expect(field(later, "driver")).to_have_value("Ada")


def test_a_read_only_page_shows_values(start: Start, read_only_server: Server, page: Page) -> None:
    start("zbot", "run", "parameter_demo").wait_for("drives")
    page.goto(f"{read_only_server.address}/parameters?node=/parameter_demo")
    expect(entry(page, "driver")).to_contain_text("Ada")
    expect(field(page, "driver")).to_have_count(0)


def publish_events(node: zbot_library.Node, number: int, event: ParameterEvent) -> None:
    publisher = node.create_publisher(ParameterEvent, "/parameter_events", 1000)
    assert wait_until(lambda: publisher.get_subscription_count() > 0)
    for _ in range(number):
        publisher.publish(event)


def test_a_forged_event_does_not_stop_the_page(demo: Page, make_context: MakeContext) -> None:
    changed = Parameter(name="driver", value=ParameterValue(type=77, string_value="Mallory"))
    event = ParameterEvent(node="/parameter_demo", changed_parameters=[changed])
    publish_events(zbot_library.Node("forger", context=make_context()), 500, event)
    assert zbot("param", "set", "/parameter_demo", "driver", "Grace").code == 0
    expect(field(demo, "driver")).to_have_value("Grace")
    expect(demo.get_by_text("This section of the page has stopped")).to_have_count(0)


def test_a_flood_of_events_does_not_load_the_parameters_each_time(
    make_context: MakeContext, spin: Spin, server: Server, page: Page
) -> None:
    node = zbot_library.Node("flooded", context=make_context(), start_parameter_services=False)
    loads: list[Any] = []

    def list_parameters(request: Any, response: Any) -> Any:
        loads.append(request)
        return response

    node.create_service(ListParameters, "flooded/list_parameters", list_parameters)
    node.create_service(SetParameters, "flooded/set_parameters", lambda _, response: response)
    spin(node)
    page.goto(f"{server.address}/parameters?node=/flooded")
    expect(page.get_by_text("This node has no parameters.")).to_be_visible()
    event = ParameterEvent(node="/flooded", new_parameters=[Parameter(name="one")])
    begun_s = time.monotonic()
    publish_events(node, 2000, event)
    assert wait_until(lambda: len(loads) > 1)
    page.wait_for_timeout(500)
    assert len(loads) < 6 + (time.monotonic() - begun_s)  # one a second
