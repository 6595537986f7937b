"""Tests of the processes panel: processor time, memory, and stopping a process."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page

    from tests.conftest import Program, Start
    from tests.web.conftest import Server


@pytest.fixture
def talker(start: Start) -> Program:
    program = start("zbot", "run", "talker")
    program.wait_for("Publishing")
    return program


def row(page: Page, node: str) -> Locator:
    return page.locator(".zb-list tbody tr").filter(has_text=node)


def test_a_process_shows_its_cpu_and_memory(talker: Program, server: Server, page: Page) -> None:
    page.goto(f"{server.address}/processes")
    expect(row(page, "/talker")).to_contain_text(str(talker.process.pid))
    expect(row(page, "/talker")).to_contain_text(re.compile(r"\d+ %"))
    expect(row(page, "/talker")).to_contain_text("MB")
    expect(page.locator(".zb-list tbody tr")).to_have_count(1)


def test_stop_ends_a_process_as_ctrl_c_does(talker: Program, server: Server, page: Page) -> None:
    page.goto(f"{server.address}/processes")
    row(page, "/talker").click()
    page.get_by_role("button", name="Stop").click()
    expect(page.locator(".zb-command")).to_have_text("zbot node kill /talker")
    assert talker.wait(20) == -2
    expect(row(page, "/talker")).to_have_count(0)
    expect(page.get_by_text("The process has ended.")).to_be_visible()


def test_the_page_does_not_stop_itself(server: Server, page: Page) -> None:
    page.goto(f"{server.address}/processes")
    page.get_by_text("Hidden nodes").click()
    row(page, str(server.program.process.pid)).click()
    expect(page.get_by_text("This process serves this page.")).to_be_visible()
    expect(page.get_by_role("button", name="Stop")).to_have_count(0)


def test_a_read_only_page_cannot_stop(
    talker: Program, read_only_server: Server, page: Page
) -> None:
    page.goto(f"{read_only_server.address}/processes")
    row(page, "/talker").click()
    expect(page.get_by_text("This page is read-only.")).to_be_visible()
    expect(page.get_by_role("button", name="Stop")).to_have_count(0)
    assert talker.process.poll() is None
