"""Tests of the stick on the screen, in a real browser and without one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.conftest import command
from zbot.observer.system import System
from zbot.web.panels.stick.stick import Stick

from sensor_msgs.msg import Joy

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable

    from playwright.sync_api import Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server


@pytest.fixture
def heard(make_context: MakeContext, spin: Spin) -> list[Any]:
    """Return a list that fills with the messages on /joy."""
    messages: list[Any] = []
    node = zbot.Node("driver", context=make_context())
    node.create_subscription(Joy, "/joy", messages.append, 10)
    spin(node)
    return messages


def wait_in_page(page: Page, condition: Callable[[], bool]) -> bool:
    def look() -> bool:
        page.wait_for_timeout(20)  # handles the browser's events
        return condition()

    return wait_until(look, 15)


def test_a_drag_moves_the_axes_and_its_end_stops(
    server: Server, page: Page, heard: list[Any]
) -> None:
    page.goto(f"{server.address}/stick")
    expect(command(page)).to_contain_text("zbot topic echo /joy")
    box = page.get_by_label("Left stick").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 30, y - 60, steps=4)  # left and up are positive
    assert wait_in_page(
        page, lambda: bool(heard) and heard[-1].axes[1] > 0.5 and heard[-1].axes[0] > 0.2
    )
    assert len(heard[-1].buttons) == 11
    page.mouse.up()
    assert wait_in_page(page, lambda: not any(heard[-1].axes))


def test_buttons_stay_pressed(server: Server, page: Page, heard: list[Any]) -> None:
    page.goto(f"{server.address}/stick?topic=/joy")
    page.get_by_role("button", name="5", exact=True).click()
    assert wait_in_page(page, lambda: bool(heard) and heard[-1].buttons[5] == 1)
    page.get_by_role("button", name="5", exact=True).click()
    assert wait_in_page(page, lambda: heard[-1].buttons[5] == 0)


def test_a_read_only_page_has_no_stick(read_only_server: Server, page: Page) -> None:
    page.goto(f"{read_only_server.address}/stick")
    expect(page.get_by_text("This page is read-only: it cannot drive.")).to_be_visible()
    expect(page.get_by_label("Left stick")).to_have_count(0)


def test_a_silent_browser_lets_go(domain: int, heard: list[Any]) -> None:
    now = [0.0]
    with System(domain_id=domain) as system:
        stick = Stick(system, "/joy", lambda: now[0])
        stick.move(0, 1.0, -1.0)
        stick.press(3, is_pressed=True)
        assert wait_until(
            lambda: (
                bool(heard)
                and heard[-1].buttons[3] == 1
                and list(heard[-1].axes)[:2] == [-1.0, -1.0]
            )
        )
        now[0] = 4.0
        assert wait_until(lambda: not any(heard[-1].axes) and not any(heard[-1].buttons))
        stick.keep_alive()
        assert wait_until(lambda: bool(heard) and heard[-1].buttons[3] == 1)
        stick.release()
        assert wait_until(lambda: not any(heard[-1].buttons))
