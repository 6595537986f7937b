"""Pictures of the page in `docs/images/`, taken from a running system: `make pictures`.

It needs a Chromium on this machine. Playwright drives it, and downloads nothing.
"""

from __future__ import annotations

import io
import os
import re
import shutil
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from PIL import Image
from playwright.sync_api import sync_playwright

if TYPE_CHECKING:
    from playwright.sync_api import Page

IMAGES = Path(__file__).parents[1] / "images"
SIZE = {"width": 1120, "height": 640}
DOMAIN = "105"
NODES = (
    ("turtlesim", "turtlesim_node", "--no-browser"),
    ("turtlesim", "draw_square"),
    ("robot_base",),
    ("robot_laser",),
    ("talker",),
    ("listener",),
)
#: How long the turtle draws before the first picture, and a plot fills, in milliseconds.
DRAWING_MS = 20_000


def start(stack: ExitStack, *words: str) -> subprocess.Popen[str]:
    """Start a command of zbot, which ends with the stack."""
    process = subprocess.Popen(  # noqa: S603 - the words are those of this module
        [sys.executable, "-m", "zbot_cli", *words],
        env={**os.environ, "ZBOT_DOMAIN_ID": DOMAIN},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    stack.callback(process.wait, 10)
    stack.callback(process.terminate)
    return process


def address_of_page(stack: ExitStack) -> str:
    """Start the page, and return its address."""
    server = start(stack, "web", "--no-browser", "--port", "0")
    assert server.stdout is not None
    for line in server.stdout:
        found = re.search(r"http://[\d.:]+", line)
        if found:
            return found[0]
    raise SystemExit("`zbot web` has ended: install zbot[web]")


def save(page: Page, name: str) -> None:
    """Save the visible part of the page with 256 colours, which makes the file small."""
    picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB").quantize(256)
    picture.save(IMAGES / f"page-{name}.png", optimize=True)


def take_pictures(page: Page, address: str) -> None:
    """Visit the panels, and save each."""
    page.goto(f"{address}/turtle")
    page.wait_for_timeout(DRAWING_MS)
    save(page, "turtle")
    page.goto(f"{address}/graph")
    page.locator("svg text", has_text="/listener").first.wait_for()
    page.wait_for_timeout(2000)  # the layout moves its items into their places
    save(page, "graph")
    page.goto(f"{address}/topics")
    page.locator(".zb-list tr[data-key='/scan']").click()
    page.wait_for_timeout(5000)  # rates are those of the last seconds
    save(page, "topics")
    page.goto(f"{address}/plot?curve=/turtle1/pose.x,/turtle1/pose.y")
    page.wait_for_timeout(DRAWING_MS)
    save(page, "plot")


def main() -> None:
    """Start the nodes and the page, and take the pictures."""
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        raise SystemExit("no Chromium on this machine: install it, e.g. apt install chromium")
    with ExitStack() as stack:
        for words in NODES:
            start(stack, "run", *words)
        address = address_of_page(stack)
        play = stack.enter_context(sync_playwright())
        chromium = play.chromium.launch(executable_path=browser, args=["--no-sandbox"])
        stack.callback(chromium.close)
        take_pictures(chromium.new_page(viewport=SIZE), address)  # type: ignore[arg-type]


if __name__ == "__main__":
    main()
