"""Tests of the panel of a class, in a real browser with real hubs."""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING

import pytest

import zbot
from tests.classroom.local_machine import LocalMachine
from tests.conftest import wait_until
from tests.web.conftest import COMMAND, Server
from zbot.classroom.sensor_rule import FORBIDDEN
from zbot.testing.domain import reserved_domain

from sensor_msgs.msg import NavSatFix

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from playwright.sync_api import Page

    from tests.conftest import MakeContext, Program, Spin
    from tests.web.conftest import Visit

NAME = "Ana <img src=x onerror=alert(1)>"

FAULTY = """
import zbot

with zbot.init():
    node = zbot.Node("wheels")
    node.get_logger().error("<b>the motor is hot</b>")
    print("ready", flush=True)
    zbot.spin(node)
"""


@pytest.fixture
def domain(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    """Reserve a domain for the class alone: a router of the shared one knows no hub of the test."""
    with reserved_domain() as number:
        monkeypatch.setenv("ZBOT_DOMAIN_ID", str(number))
        yield number


@pytest.fixture
def teacher(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, domain: int) -> Iterator[LocalMachine]:
    """Open a class on this machine; the programs of the test see it as the teacher's machine."""
    machine = LocalMachine(tmp_path / "teacher")
    for name in ("XDG_CONFIG_HOME", "ZBOT_HUB_PORT"):
        monkeypatch.setenv(name, machine.environment[name])
    monkeypatch.setenv("ZBOT_COMMAND_DOMAIN", str(domain))  # not that of other tests' teachers
    machine.succeed("class", "start", "Robots")
    yield machine
    machine.switch_off()


@pytest.fixture
def student(teacher: LocalMachine, tmp_path: Path, domain: int) -> Iterator[LocalMachine]:
    """Add a student whose number is the test's domain."""
    machine = LocalMachine(tmp_path / "student")
    number = ("--number", str(domain))
    machine.succeed("join", f"127.0.0.1:{teacher.port}", "--name", NAME, *number)
    yield machine
    machine.switch_off()


def test_each_student_has_a_card_that_opens_the_graph(
    page: Page,
    student: LocalMachine,
    start: Callable[..., Program],
    serve: Callable[..., object],
    domain: int,
) -> None:
    start(source=FAULTY, env=student.environment).wait_for("ready")
    address = getattr(serve(), "address", "")
    page.goto(f"{address}/class")
    card = page.locator(".zb-student")
    card.get_by_text("1 node", exact=True).wait_for()
    card.get_by_text(NAME, exact=True).wait_for()
    card.get_by_text("wheels: <b>the motor is hot</b>", exact=True).wait_for()
    page.get_by_text("Robots: 1 of 1 here").wait_for()
    card.click()
    page.get_by_text(f"Graph of {domain}").wait_for()
    page.get_by_text(f"zbot graph /{domain}").wait_for()
    page.wait_for_function(
        "() => document.querySelector('img[alt*=graph]')?.src.startsWith('data:image/svg')"
    )
    assert re.search(rf"/class\?student={domain}$", page.url)


def test_the_teacher_opens_the_view_of_a_student(
    page: Page,
    student: LocalMachine,
    start: Callable[..., Program],
    serve: Callable[..., object],
    domain: int,
) -> None:
    pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')
    start(source=FAULTY, env=student.environment).wait_for("ready")
    address = getattr(serve(), "address", "")
    page.goto(f"{address}/class?student={domain}")
    with page.expect_popup() as opened:
        page.get_by_role("link", name="Open the 3D view").click()
    view = opened.value
    inner = view.frame_locator("iframe[title='3D view']")
    inner.get_by_text(f"zbot, domain {domain}").wait_for()
    view.get_by_text(f"zbot --domain {domain} view").wait_for()
    view.close()
    page.goto(f"{address}/view?student=999")
    page.get_by_text("the class has no student 999").wait_for()


def test_a_student_who_leaves_the_network_is_shown_as_lost(
    page: Page, student: LocalMachine, serve: Callable[..., object]
) -> None:
    page.goto(f"{getattr(serve(), 'address', '')}/class")
    page.locator(".zb-student").get_by_text("0 nodes").wait_for()
    student.kill_hub()
    page.locator(".zb-student-lost").get_by_text(re.compile("lost [0-9]+ s ago")).wait_for()


def test_page_without_a_class_says_how_to_open_one(page: Page, server: object) -> None:
    page.goto(f"{getattr(server, 'address', '')}/class")
    page.get_by_text("no class is open on this machine").wait_for()


def test_the_teachers_browser_shows_code_pin_and_qr_code(
    page: Page, teacher: LocalMachine, serve: Callable[..., object]
) -> None:
    teacher.succeed("class", "stop")
    told = teacher.succeed("class", "start", "Secrets", "--pin", "--json", ZBOT_PIN="4711")
    page.goto(f"{getattr(serve(), 'address', '')}/class")
    page.get_by_role("button", name="Show the code").click()
    card = page.locator(".zb-invitation")
    card.get_by_text("PIN 4711").wait_for()
    card.get_by_text(f"zbot join {json.loads(told)['host']}:{teacher.port}").first.wait_for()
    width = "() => document.querySelector('.zb-invitation img').naturalWidth > 100"
    page.wait_for_function(width)
    page.get_by_role("button", name="Hide the code").click()
    card.wait_for(state="hidden")


def test_a_teacher_forbids_the_sensors_of_browsers_and_allows_them_again(
    visit: Callable[..., Visit],
    teacher: LocalMachine,
    student: LocalMachine,
    start: Callable[..., Program],
    make_context: MakeContext,
    spin: Spin,
) -> None:
    heard: list[NavSatFix] = []
    node = zbot.Node("listener", context=make_context())
    node.create_subscription(NavSatFix, "/laptop/fix", heard.append, 10)
    spin(node)
    place = {"latitude": 46.5, "longitude": 6.6, "accuracy": 10}
    page = visit(geolocation=place, permissions=["geolocation"]).page
    page.goto(f"{Server(start(*COMMAND, env=student.environment)).address}/sensors")
    switch = page.get_by_role("switch", name="Position")
    switch.click()
    assert wait_until(lambda: bool(heard))
    told = teacher.succeed("class", "start", "--no-sensors")
    assert "The live page publishes no sensors of browsers in this class" in told
    expect(page.get_by_text(FORBIDDEN).first).to_be_visible()
    expect(switch).to_be_disabled()
    assert wait_until(lambda: node.count_publishers("/laptop/fix") == 0)
    heard.clear()
    # The server itself refuses, also if the browser goes on.
    page.evaluate("emitEvent('zbot_sensor', ['position', 1, [46.5, 6.6, null, 10, null]])")
    page.reload()
    expect(switch).to_be_disabled()
    assert not heard
    teacher.succeed("class", "start", "--sensors")
    expect(switch).to_be_enabled()
    switch.click()
    assert wait_until(lambda: bool(heard))
