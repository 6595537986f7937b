"""Test of the launch panel in a browser."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from tests.web.conftest import SCREENS, command, settled
from tests.web.test_frames_panel import BEYOND

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from playwright.sync_api import Locator, Page

    from tests.conftest import Program, Start
    from tests.web.conftest import Server

LAUNCH = """import sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess
CODE = "print('<b>up</b>', flush=True); import time; time.sleep(1000)"
def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=[sys.executable, "-c", CODE], name="waiter"),
        ExecuteProcess(cmd=[sys.executable, "-c", "raise SystemExit(3)"], name="broken"),
    ])
"""


@pytest.fixture
def launch(start: Start, tmp_path: Path, domain: int) -> Program:  # noqa: ARG001
    path = tmp_path / "demo.launch.py"
    path.write_text(LAUNCH)
    program = start("zbot", "launch", str(path))
    program.wait_for("process started")
    return program


def row(page: Page, name: str) -> Locator:
    return page.locator(".zb-list tbody tr").filter(has=page.get_by_text(name, exact=True))


def press(page: Page, name: str) -> None:
    """Press a button with the keyboard."""
    page.get_by_role("button", name=name, exact=True).press("Enter")


def test_a_launch_is_seen_restarted_and_stopped(
    launch: Program, serve: Callable[..., Server], page: Page
) -> None:
    server = serve()
    page.goto(f"{server.address}/launch")
    expect(row(page, "demo.launch.py")).to_contain_text("1 running")
    expect(row(page, "broken-2")).to_contain_text("failed, exit code 3")
    row(page, "waiter-1").press("Enter")
    output = page.get_by_role("log", name="Output")
    expect(output).to_have_text("<b>up</b>")
    press(page, "Restart")
    expect(output).to_contain_text("-- started again --\n<b>up</b>")
    press(page, "Stop")
    expect(page.get_by_role("dialog")).to_contain_text("waiter-1 will end")
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_have_count(0)
    expect(row(page, "waiter-1")).to_contain_text("running")
    row(page, "demo.launch.py").press("Enter")
    expect(command(page)).to_contain_text("demo.launch.py")
    press(page, "Stop the launch")
    page.get_by_role("dialog").get_by_role("button", name="Stop").press("Enter")
    expect(page.locator(".zb-list")).to_contain_text("No launch runs here")
    expect(page.get_by_text("The launch has ended.")).to_be_visible()
    launch.process.wait(10)


@pytest.mark.usefixtures("launch")
def test_a_read_only_page_stops_nothing(serve: Callable[..., Server], page: Page) -> None:
    server = serve("--read-only")
    page.goto(f"{server.address}/launch")
    row(page, "waiter-1").click()
    expect(page.get_by_text("This page is read-only.")).to_be_visible()
    expect(page.get_by_role("button", name="Stop", exact=True)).to_have_count(0)


@pytest.mark.usefixtures("launch")
def test_the_panel_fits(page: Page, serve: Callable[..., Server]) -> None:
    server = serve()
    page.goto(f"{server.address}/launch")
    row(page, "waiter-1").click()
    expect(page.get_by_role("log", name="Output")).to_have_text("<b>up</b>")
    for size in SCREENS:
        page.set_viewport_size(size)
        assert settled(page, lambda: page.evaluate(BEYOND)) == [], size
