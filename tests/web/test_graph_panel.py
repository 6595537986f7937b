from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from functools import partial
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET

import pytest

import zbot
from tests.conftest import allowed, wait_until
from tests.web.conftest import command, settled

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from std_msgs.msg import Int32, String

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from playwright.sync_api import Page

    from tests.conftest import Program, Spinner
    from tests.web.conftest import Server

#: It takes 0.3 s on an idle machine.
_SOON_S = 3.0


class Nodes:
    """Factory of nodes that exist until the test ends."""

    def __init__(self, context: zbot.Context) -> None:
        self._context = context
        self._made: list[zbot.Node] = []

    def __call__(self, name: str, namespace: str = "") -> zbot.Node:
        made = zbot.Node(
            name, context=self._context, namespace=namespace, start_parameter_services=False
        )
        self._made.append(made)
        return made


@pytest.fixture
def node(make_context: Callable[[], zbot.Context]) -> Nodes:
    return Nodes(make_context())


def talk(node: Nodes) -> tuple[zbot.Node, zbot.Node]:
    talker, listener = node("talker"), node("listener")
    talker.create_publisher(String, "chatter", 10)
    listener.create_subscription(String, "chatter", print, 10)
    return talker, listener


def of(name: str) -> str:
    return f".zb-graph [data-node='{name}'], .zb-graph [data-topic='{name}'].topic"


def drawn(page: Page, what: str) -> list[str]:
    script = (
        f"[...document.querySelectorAll('.zb-graph .{what}[data-key]')].map(one => one.dataset.key)"
    )
    return sorted(page.evaluate(script))


def shows(page: Page, *nodes: str) -> bool:
    """Wait until exactly these nodes are drawn."""
    return wait_until(lambda: drawn(page, "node") == [f"n:{name}" for name in nodes])


def place(page: Page, name: str) -> tuple[int, int]:
    box = page.locator(of(name)).bounding_box()
    assert box is not None
    return round(box["x"]), round(box["y"])


def test_page_shows_what_the_command_prints(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    camera = node("camera", "/robot")
    camera.create_publisher(String, "image", 10)
    for options in ("", "show=active", "no-dead-sinks=1&nodes=-/talker", "debug-topics=1"):
        page.goto(f"{server.address}/graph?{options}")
        page.wait_for_selector(of("/listener"))
        words = settled(page, command(page).inner_text).split()
        assert words[:2] == ["zbot", "graph"]
        out = subprocess.run(
            [sys.executable, "-m", "zbot_cli", *words[1:], "--json"],
            capture_output=True,
            check=True,
            timeout=allowed(30),
        ).stdout
        printed = json.loads(out)
        assert shows(page, *printed["nodes"]), drawn(page, "node")
        topics = [f"t:{topic['name']}" for topic in printed["topics"]]
        assert wait_until(lambda topics=topics: drawn(page, "topic") == topics)  # type: ignore[misc]
        count = len(printed["edges"])
        assert wait_until(lambda count=count: len(drawn(page, "edge")) == count)  # type: ignore[misc]


def test_new_and_ended_nodes_are_shown_at_once(
    server: Server, page: Page, node: Nodes, start: Callable[..., Program]
) -> None:
    page.goto(f"{server.address}/graph")
    page.wait_for_selector("text=no node is running")
    begin = time.monotonic()
    talk(node)
    page.wait_for_selector(of("/talker"))
    page.wait_for_selector(of("/chatter"))
    assert time.monotonic() - begin < allowed(_SOON_S)
    program = start("zbot", "run", "sensor")
    page.wait_for_selector(of("/temperature"))
    begin = time.monotonic()
    program.stop(signal.SIGKILL)
    page.wait_for_selector(of("/temperature"), state="detached")
    page.wait_for_selector(of("/temperature_sensor"), state="detached")
    assert time.monotonic() - begin < allowed(_SOON_S)
    assert shows(page, "/listener", "/talker")


def test_boxes_keep_their_places(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(of("/chatter"))
    page.locator(".zb-graph").hover()
    fitted = settled(page, partial(place, page, "/talker"))
    page.mouse.wheel(0, 10)  # this ends the fit of the picture to the page
    assert wait_until(lambda: place(page, "/talker") != fitted)
    before = {
        name: settled(page, partial(place, page, name))
        for name in ("/talker", "/chatter", "/listener")
    }
    node("late").create_subscription(String, "chatter", print, 10)
    page.wait_for_selector(of("/late"))
    settled(page, partial(place, page, "/late"))
    for name, spot in before.items():
        assert place(page, name) == pytest.approx(spot, abs=2)


def test_modes_and_filters_are_in_the_address(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(of("/chatter"))
    page.click("button:has-text('Nodes')")
    page.wait_for_selector(of("/chatter"), state="detached")
    page.wait_for_selector(".zb-graph .edge text:has-text('/chatter')")
    page.fill("input[aria-label=Nodes]", "-/listener")
    page.wait_for_selector(of("/listener"), state="detached")
    page.wait_for_url("**/graph?show=nodes&nodes=-%2Flistener")
    expect(command(page)).to_have_text("zbot graph --show nodes --nodes -/listener")
    page.reload()
    page.wait_for_selector(of("/talker"))
    assert shows(page, "/talker")
    expect(page.locator("input[aria-label=Nodes]")).to_have_value("-/listener")


def test_an_invalid_filter_changes_nothing(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(of("/chatter"))
    page.fill("input[aria-label=Topics]", "/chat(")
    page.wait_for_selector(".q-field--error")
    assert drawn(page, "topic") == ["t:/chatter"]


def test_a_menu_selects_what_is_hidden_and_grouped(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(of("/chatter"))
    page.wait_for_selector(".zb-graph-left-out:has-text('/rosout')")
    page.click("button[aria-label='Hide and group']")
    page.click(".zb-graph-tick:has-text('Debug')")
    page.wait_for_selector(of("/rosout"))
    page.wait_for_url("**/graph?debug-topics=1")


def test_probable_mistakes_are_red_with_a_sentence(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    lost = node("lost")
    lost.create_subscription(Int32, "chatter", print, 10)
    lost.create_subscription(String, "chater", print, 10)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(".zb-graph .topic.wrong[data-topic='/chatter']")
    page.wait_for_selector(".zb-graph .topic.wrong[data-topic='/chater']")
    said = page.locator(".zb-graph-problems")
    expect(said).to_contain_text("nobody publishes /chater; did you mean '/chatter'?")
    types = "std_msgs/msg/Int32 (/lost), std_msgs/msg/String (/listener, /talker)"
    expect(said).to_contain_text(types)
    wrong = ["e:t:/chater>n:/lost#", "e:t:/chatter>n:/lost#"]
    assert wait_until(lambda: drawn(page, "edge.wrong") == wrong), drawn(page, "edge.wrong")


def test_the_mouse_highlights_neighbours(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    node("other")
    page.goto(f"{server.address}/graph")
    page.locator(of("/chatter")).hover()
    page.wait_for_selector(".zb-graph .node.incoming[data-node='/talker']")
    page.wait_for_selector(".zb-graph .node.outgoing[data-node='/listener']")
    assert drawn(page, "chosen") == ["t:/chatter"]
    assert not page.locator(".zb-graph .both, .zb-graph .incoming[data-node='/other']").count()
    page.mouse.move(0, 0)
    page.wait_for_selector(".zb-graph .incoming", state="detached")


def test_a_click_shows_details_and_the_command(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    page.locator(of("/talker")).click()
    page.wait_for_selector(".zb-side:has-text('std_msgs/msg/String') >> text=Publishes")
    expect(command(page)).to_have_text("zbot node info /talker")
    page.locator(of("/chatter")).click()
    page.wait_for_selector(".zb-side:has-text('Published by'):has-text('/talker')")
    expect(command(page)).to_have_text("zbot topic info /chatter --verbose")
    page.reload()
    page.wait_for_selector(".zb-side >> text=Published by")
    page.click(".zb-side button[aria-label=Close]")
    page.wait_for_selector(".zb-side", state="hidden")
    expect(command(page)).to_have_text("zbot graph")


def test_rates_are_measured_only_on_request(
    server: Server, page: Page, node: Nodes, spin: Callable[..., Spinner]
) -> None:
    talker, listener = talk(node)
    publisher = talker.create_publisher(String, "news", 10)
    listener.create_subscription(String, "news", lambda _: None, 10)
    talker.create_timer(0.02, lambda: publisher.publish(String(data="x")))
    spin(talker)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(of("/news"))
    assert wait_until(lambda: publisher.get_subscription_count() == 1)
    page.click("text=Rates")
    page.wait_for_selector(".zb-graph .rate:has-text('Hz')")
    assert wait_until(lambda: publisher.get_subscription_count() == 2)
    texts = page.locator(".zb-graph .rate").all_text_contents()
    assert all(re.fullmatch(r"[\d.]+ Hz|", text) for text in texts)
    page.click("text=Rates")
    page.wait_for_selector(".zb-graph .rate", state="detached")
    assert wait_until(lambda: publisher.get_subscription_count() == 1)


def test_a_picture_is_downloaded(server: Server, page: Page, node: Nodes, tmp_path: Path) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    page.wait_for_selector(of("/chatter"))
    saved = {}
    for name in ("SVG", "PNG", "DOT"):
        page.click("button[aria-label=Save]")
        with page.expect_download() as download:
            page.click(f".q-menu .q-item:has-text('{name}')")
        target = tmp_path / download.value.suggested_filename
        download.value.save_as(target)
        saved[target.name] = target.read_bytes()
    names = [element.get("data-node") for element in ET.fromstring(saved["graph.svg"]).iter()]
    assert [name for name in names if name] == ["/listener", "/talker"]
    assert saved["graph.png"].startswith(b"\x89PNG\r\n\x1a\n")
    assert len(saved["graph.png"]) > 5_000
    assert saved["graph.dot"].startswith(b"digraph graph_of_nodes {")


def test_the_wheel_zooms_and_dragging_moves(server: Server, page: Page, node: Nodes) -> None:
    talk(node)
    page.goto(f"{server.address}/graph")
    before = settled(page, partial(place, page, "/talker"))
    page.locator(of("/chatter")).hover()
    page.mouse.wheel(0, -200)
    assert wait_until(lambda: place(page, "/talker")[0] < before[0])
    page.click("button[aria-label='Show all']")
    assert wait_until(lambda: place(page, "/talker") == pytest.approx(before, abs=2))
    settled(page, partial(place, page, "/talker"))
    page.mouse.move(300, 560)
    page.mouse.down()
    page.mouse.move(360, 500, steps=3)
    page.mouse.up()
    moved = pytest.approx((before[0] + 60, before[1] - 60), abs=3)
    assert wait_until(lambda: place(page, "/talker") == moved), place(page, "/talker")


def test_a_large_graph_is_drawn_at_once(server: Server, page: Page, node: Nodes) -> None:
    nodes = [node(f"node_{number}") for number in range(50)]
    for number in range(150):
        nodes[number % 50].create_publisher(String, f"part_{number % 7}/topic_{number}", 1)
        other = nodes[(number + 1 + number // 50) % 50]
        other.create_subscription(String, f"part_{number % 7}/topic_{number}", print, 1)
    page.goto(f"{server.address}/graph")
    page.wait_for_function("document.querySelectorAll('.zb-graph .item').length === 200")
    begin = time.monotonic()
    page.reload()
    page.wait_for_function("document.querySelectorAll('.zb-graph .item').length === 200")
    assert time.monotonic() - begin < allowed(10)  # 1.5 s on an idle machine
