"""Pictures in `docs/images/` of the page and the view of a running system: `make pictures`.

It needs a Chromium on this machine. Playwright drives it, and downloads nothing.
"""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import quote

from PIL import Image
from playwright.sync_api import sync_playwright

if TYPE_CHECKING:
    from playwright.sync_api import Page

IMAGES = Path(__file__).parents[1] / "images"
SIZE = {"width": 1120, "height": 640}
DOMAIN = "105"
#: The view needs WebGL, also on a machine without a graphics card.
ARGUMENTS = ["--no-sandbox", "--enable-unsafe-swiftshader"]
NODES = (
    ("turtlesim", "turtlesim_node", "--no-browser"),
    ("turtlesim", "draw_square"),
    ("robot_base",),
    ("robot_laser",),
    ("robot_camera",),
    ("talker",),
    ("listener",),
)
VIEW_DOMAIN = "106"  # an own domain: the robot has a whole launch file

#: How long the turtle draws before the first picture, and a plot fills, in milliseconds.
DRAWING_MS = 20_000


def start(stack: ExitStack, *words: str, domain: str = DOMAIN) -> subprocess.Popen[str]:
    """Start a command of zbot, which ends with the stack."""
    process = subprocess.Popen(  # noqa: S603 - the words are those of this module
        [sys.executable, "-m", "zbot_cli", *words],
        env={**os.environ, "ZBOT_DOMAIN_ID": domain},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    stack.callback(process.wait, 10)
    stack.callback(process.terminate)
    return process


def address_of(stack: ExitStack, command: str, domain: str = DOMAIN) -> str:
    """Start `zbot web` or `zbot view`, and return its address."""
    server = start(stack, command, "--no-browser", "--port", "0", domain=domain)
    assert server.stdout is not None
    for line in server.stdout:
        found = re.search(r"http://[\d.:]+", line)
        if found:
            return found[0]
    raise SystemExit(f"`zbot {command}` has ended: install zbot[{command}]")


def save(page: Page, name: str) -> None:
    """Save the visible part of the page with 256 colours, which makes the file small."""
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB").quantize(256)
    picture.save(IMAGES / f"{name}.png", optimize=True)


def take_pictures(page: Page, address: str) -> None:
    """Visit the panels, and save each."""
    page.goto(f"{address}/turtle")
    page.wait_for_timeout(DRAWING_MS)
    save(page, "page-turtle")
    page.goto(f"{address}/graph")
    page.locator("svg text", has_text="/listener").first.wait_for()
    page.wait_for_timeout(2000)  # the layout moves its items into their places
    save(page, "page-graph")
    page.goto(f"{address}/topics")
    page.locator(".zb-list tr[data-key='/scan']").click()
    page.wait_for_timeout(5000)  # rates are those of the last seconds
    save(page, "page-topics")
    page.goto(f"{address}/drive?topic=/cmd_vel")
    page.get_by_alt_text("The last image").wait_for()
    page.keyboard.down("w")
    page.wait_for_timeout(1000)  # until the velocity is shown
    save(page, "page-drive")
    page.keyboard.up("w")
    page.goto(f"{address}/plot?curve=/turtle1/pose.x,/turtle1/pose.y")
    page.wait_for_timeout(DRAWING_MS)
    save(page, "page-plot")


def take_picture_of_view(page: Page, address: str) -> None:
    """Look at the simulated robot in 3D."""
    page.goto(address)
    page.get_by_text("The fixed frame is odom.").wait_for()
    page.get_by_text("Settings", exact=True).first.click()
    page.get_by_label("names", exact=True).uncheck()
    page.get_by_text("Settings", exact=True).first.click()
    page.get_by_label("/odom").check()
    page.wait_for_timeout(DRAWING_MS)
    for close in page.locator(".mantine-Notification-closeButton").all():
        close.click()  # the notice that WebGL runs in software
    page.get_by_text("The fixed frame is odom.").scroll_into_view_if_needed()
    page.mouse.move(400, 320)
    page.mouse.wheel(0, -600)  # closer
    page.wait_for_timeout(2000)
    save(page, "view")


def take_picture_of_layout(page: Page, address: str) -> None:
    """Look at the simulated robot on a page of one's own."""
    rows = [["view", "pictures"], ["graph", "topics?topic=/odom"]]
    page.set_viewport_size({"width": SIZE["width"] + 320, "height": SIZE["height"] + 180})
    page.goto(f"{address}/layout?layout={quote(json.dumps({'rows': rows}))}")
    view = page.frame_locator("iframe[title^=View]").frame_locator("iframe")
    view.get_by_text("The fixed frame is odom.").wait_for()
    for close in view.locator(".mantine-Notification-closeButton").all():
        close.click()
    page.wait_for_timeout(DRAWING_MS)
    save(page, "page-layout")


def main() -> None:
    """Start the nodes and the page, and take the pictures."""
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        raise SystemExit("no Chromium on this machine: install it, e.g. apt install chromium")
    with ExitStack() as stack:
        for words in NODES:
            start(stack, "run", *words)
        start(stack, "launch", "zbot_nodes", "robot.launch.py", domain=VIEW_DOMAIN)
        address = address_of(stack, "web")
        view = address_of(stack, "view", VIEW_DOMAIN)
        page_of_robot = address_of(stack, "web", VIEW_DOMAIN)
        play = stack.enter_context(sync_playwright())
        chromium = play.chromium.launch(executable_path=browser, args=ARGUMENTS)
        stack.callback(chromium.close)
        page = chromium.new_page(viewport=SIZE)  # type: ignore[arg-type]
        take_picture_of_view(page, view)
        take_pictures(page, address)
        take_picture_of_layout(page, page_of_robot)


if __name__ == "__main__":
    main()
