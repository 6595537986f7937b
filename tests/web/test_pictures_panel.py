"""Test of the pictures panel in a browser."""

from __future__ import annotations

import io
import re
from typing import TYPE_CHECKING
from urllib.parse import quote

import pytest

import zbot
from tests.conftest import wait_until
from tests.web.conftest import SCREENS, command, settled
from tests.web.test_frames_panel import BEYOND

pytest.importorskip("playwright.sync_api", reason="Playwright is not installed")

from playwright.sync_api import expect

from sensor_msgs.msg import CompressedImage, Image

if TYPE_CHECKING:
    from playwright.sync_api import Page

    from tests.conftest import MakeContext, Spin
    from tests.web.conftest import Server

LEFT, RIGHT = "/left/image", "/right/image/compressed"


class Cameras:
    """Node with two cameras, which see one colour."""

    def __init__(self, node: zbot.Node) -> None:
        self.node, self.red = node, 255
        self.left = node.create_publisher(Image, LEFT, 1)
        self.right = node.create_publisher(CompressedImage, RIGHT, 1)
        self.timer = node.create_timer(0.1, self.publish)

    def publish(self) -> None:
        from PIL import Image as Picture  # noqa: PLC0415 - an extra

        left = Image(width=4, height=2, step=12, encoding="rgb8", data=[self.red, 0, 0] * 8)
        left.header.stamp = self.node.get_clock().now().to_msg()
        self.left.publish(left)
        file = io.BytesIO()
        Picture.new("RGB", (8, 8), (0, 0, 255)).save(file, "PNG")
        self.right.publish(CompressedImage(format="png", data=file.getvalue()))


@pytest.fixture
def cameras(server: Server, make_context: MakeContext, spin: Spin) -> Cameras:  # noqa: ARG001
    node = zbot.Node("cameras", context=make_context())
    cameras = Cameras(node)
    spin(node)
    return cameras


def color(page: Page, topic: str) -> list[int]:
    """Return red, green and blue of the middle of a picture."""
    script = """image => { const canvas = new OffscreenCanvas(1, 1).getContext('2d');
        canvas.drawImage(image, 0, 0, 1, 1); return [...canvas.getImageData(0, 0, 1, 1).data]; }"""
    found: list[int] = page.get_by_alt_text(topic, exact=True).evaluate(script)
    return found[:3]


def test_two_cameras_are_side_by_side_and_pause(
    cameras: Cameras, server: Server, page: Page
) -> None:
    page.goto(f"{server.address}/pictures")
    left = page.locator("figure").filter(has_text=LEFT)
    right = page.locator("figure").filter(has_text=RIGHT)
    expect(left).to_contain_text(re.compile(r"\d Hz, latency .*4 x 2, rgb8"))
    expect(right).to_contain_text(re.compile(r"\d Hz, no time stamp, png"))
    assert color(page, LEFT)[0] > 200
    assert color(page, RIGHT)[2] > 200
    page.get_by_label(f"Pause {LEFT}", exact=True).press("Enter")
    expect(left).to_contain_text("paused, 4 x 2")
    cameras.red = 0
    expect(page.get_by_label(f"Go on with {LEFT}", exact=True)).to_be_visible()
    assert color(page, LEFT)[0] > 200
    page.get_by_label(f"Go on with {LEFT}", exact=True).press("Enter")
    assert wait_until(lambda: color(page, LEFT)[0] < 50)
    # The address keeps which topics are shown.
    page.get_by_label(f"Close {RIGHT}", exact=True).press("Enter")
    expect(right).to_have_count(0)
    expect(command(page)).to_have_text(f"zbot topic hz {LEFT}")
    expect(page).to_have_url(f"{server.address}/pictures?topics={quote(LEFT, safe='')}")
    page.reload()
    expect(left).to_be_visible()
    expect(right).to_have_count(0)
    page.get_by_label("Add a topic").click()
    page.get_by_role("option", name=RIGHT).click()
    expect(right).to_contain_text("png")


@pytest.mark.usefixtures("cameras")
def test_the_panel_fits(server: Server, page: Page) -> None:
    page.set_viewport_size(SCREENS[0])
    page.goto(f"{server.address}/pictures")
    expect(page.get_by_alt_text(RIGHT)).to_be_visible()
    for size in SCREENS:
        page.set_viewport_size(size)
        assert settled(page, lambda: page.evaluate(BEYOND)) == [], size
