"""Tests of the bags panel: recording, timeline, plot and export."""

from __future__ import annotations

import re
import shutil
from typing import TYPE_CHECKING

import pytest

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

import zbot
from tests.conftest import wait_until
from zbot.bag import Writer, read

from sensor_msgs.msg import Image
from std_msgs.msg import Float64, String

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Locator, Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Return the folder of the page. Its bags are removed at the end."""
    path = tmp_path_factory.getbasetemp()
    yield path
    for name in ("lesson", "recorded", "pictures"):
        shutil.rmtree(path / name, ignore_errors=True)


@pytest.fixture
def bag(folder: Path) -> Path:
    """Return a bag with a text every second and a number every tenth of a second, for 10 s."""
    with Writer(folder / "lesson") as writer:
        for number in range(101):
            writer.write("/height", Float64(data=number / 10), 10**9 + number * 10**8)
            if number % 10 == 0:
                writer.write("/words", String(data=str(number)), 10**9 + number * 10**8)
    return folder / "lesson"


@pytest.fixture
def heard(make_context: MakeContext, spin: Spin) -> list[float]:
    """Return a list that fills with the numbers on /height."""
    found: list[float] = []
    node = zbot.Node("ear", context=make_context())
    node.create_subscription(Float64, "/height", lambda message: found.append(message.data), 100)
    spin(node)
    return found


def row(page: Page, name: str) -> Locator:
    return page.locator(".zb-list tbody tr").filter(has_text=name)


def opened(server: Server, page: Page, name: str) -> None:
    page.goto(f"{server.address}/bags")
    row(page, name).click()
    expect(page.get_by_label("Play", exact=True)).to_be_visible()


def play(server: Server, page: Page, name: str, heard: list[float]) -> None:
    """Open a bag, and play it until messages are heard."""
    opened(server, page, name)
    page.get_by_label("Play", exact=True).click()
    assert wait_until(lambda: len(heard) > 5)


def test_a_click_records_all_topics(
    server: Server, page: Page, folder: Path, make_context: MakeContext, spin: Spin
) -> None:
    node = zbot.Node("robot", context=make_context())
    publisher = node.create_publisher(Float64, "height", 10)
    node.create_timer(0.02, lambda: publisher.publish(Float64(data=1.0)))
    spin(node)
    page.goto(f"{server.address}/bags")
    page.get_by_role("button", name="Record").click()
    page.get_by_label("Name of the bag").fill("../recorded")
    page.get_by_role("button", name="Start").click()
    expect(page.get_by_text("is no name for a bag")).to_be_visible()
    page.get_by_label("Name of the bag").fill("recorded")
    page.get_by_role("button", name="Start").click()
    state = page.locator(".zb-recording")
    expect(state).to_contain_text(re.compile(r"recorded: \d+ s, .*B free on the disk"))
    expect(page.locator(".zb-command")).to_have_text("zbot bag record -o recorded -a")
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    file = folder / "recorded" / "recorded_0.mcap"
    assert wait_until(lambda: file.exists() and file.stat().st_size > 2000)
    state.get_by_role("button", name="Stop").click()
    expect(state).to_be_hidden()
    expect(row(page, "recorded")).to_be_visible()
    assert {topic for topic, _, _ in read(folder / "recorded")} >= {"/height"}


def test_the_timeline_plays_pauses_steps_and_seeks(
    server: Server, page: Page, bag: Path, heard: list[float]
) -> None:
    play(server, page, bag.name, heard)
    expect(page.locator(".zb-command")).to_have_text("zbot bag play lesson")
    page.get_by_label("Play", exact=True).click()
    expect(page.get_by_text("paused")).to_be_visible()
    count = len(heard)
    page.get_by_label("Step").click()
    assert wait_until(lambda: len(heard) >= count)
    box = page.locator(".zb-timeline").bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] * 0.8, box["y"] + box["height"] / 2)
    assert wait_until(lambda: bool(heard) and heard[-1] > 7)  # what was there is published
    expect(page.get_by_text("/ 10.00 s paused")).to_contain_text(re.compile(r"^[78]\."))
    page.get_by_label("Play", exact=True).click()
    assert wait_until(lambda: bool(heard) and heard[-1] == 10.0)
    expect(page.get_by_text("/ 10.00 s")).to_contain_text("10.00")


def test_a_slow_click_on_the_timeline_of_a_playback_goes_where_it_was(
    server: Server, page: Page, bag: Path, heard: list[float]
) -> None:
    play(server, page, bag.name, heard)
    box = page.locator(".zb-timeline").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] * 0.8, box["y"] + box["height"] / 2)
    page.mouse.down()
    count = len(heard)
    assert wait_until(lambda: len(heard) > count + 3)  # the player has moved the timeline meanwhile
    page.mouse.up()
    assert wait_until(lambda: heard[-1] > 7)
    assert not [value for value in heard if 3 < value < 6]  # it did not play on until there
    page.get_by_label("Stop playing").click()
    expect(page.get_by_text("0.00 / 10.00 s")).to_be_visible()


def test_the_plot_shows_the_whole_bag_at_once(
    server: Server, page: Page, bag: Path, heard: list[float]
) -> None:
    opened(server, page, bag.name)
    page.get_by_label("Curves").click()
    page.get_by_role("option", name="/height.data").click()
    expect(page.get_by_role("option", name="/words.data")).to_have_count(0)
    page.keyboard.press("Escape")
    page.wait_for_function(
        """() => [...document.querySelectorAll('.zb-bag-chart path')].some(
            path => path.getBBox().height > 80 && path.getAttribute('fill') === 'none')"""
    )
    assert heard == []  # nothing was played


def test_a_part_is_exported_as_csv_and_as_video(
    server: Server, page: Page, bag: Path, folder: Path
) -> None:
    opened(server, page, bag.name)
    page.get_by_label("From s").fill("9.75")
    with page.expect_download() as download:
        page.get_by_role("button", name="CSV").click()
    text = download.value.path().read_text()
    assert text == "time,data\n10.800000000,9.8\n10.900000000,9.9\n11.000000000,10.0\n"
    expect(page.get_by_role("button", name="Video")).to_be_disabled()
    with Writer(folder / "pictures") as writer:
        for number in range(5):
            image = Image(encoding="rgb8", width=4, height=2, step=12, data=[number] * 24)
            writer.write("/camera", image, 10**9 + number * 10**8)
    opened(server, page, "pictures")
    with page.expect_download() as download:
        page.get_by_role("button", name="Video").click()
    data = download.value.path().read_bytes()
    assert data[:4] == b"RIFF"
    assert data[8:12] == b"AVI "
    assert data.count(b"\xff\xd8\xff") == 5


def test_a_read_only_page_only_shows(read_only_server: Server, page: Page, bag: Path) -> None:
    opened(read_only_server, page, bag.name)
    expect(page.get_by_role("button", name="Record")).to_be_hidden()
    expect(page.get_by_label("Play", exact=True)).to_be_disabled()
    expect(page.get_by_text("std_msgs/msg/Float64, 101")).to_be_visible()
