"""Measure the 3D view in a browser: pictures a second, processor time, and what is sent.

Run: python -m benchmarks.view [--seconds 10] [--size 1280x720] [--scenes all,cloud]

The scene has a cloud of 100,000 points 10 times a second, 200 frames that move 50 times a second,
and a robot whose 20 links are surfaces with 5,120 triangles. The browser is a Chromium without a
window, which draws WebGL in software. A picture counts if WebGL has drawn in it. 100 % is one core.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import math
import os
import queue
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

import numpy as np
import psutil

import zbot
from zbot.libraries.point_cloud import create_cloud_xyz32
from zbot.qos import DurabilityPolicy, QoSProfile

from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import Header, String
from tf2_msgs.msg import TFMessage

if TYPE_CHECKING:
    from collections.abc import Iterator

    from playwright.sync_api import Browser, Page

#: What each row shows.
SCENES = {
    "empty": (),
    "frames": ("frames",),
    "robot": ("frames", "robot"),
    "cloud": ("cloud",),
    "all": ("frames", "robot", "cloud"),
}
FRAMES, LINKS, POINTS = 200, 20, 100_000
_DOMAIN = 79
_START_S = 60.0
_ARGUMENTS = ("--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader")
#: Counts the pictures in which WebGL has drawn, and how long the browser took for each of them.
_COUNTER = """
window.pictures = 0;
let hasDrawn = false;
for (const name of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) {
  const draw = WebGL2RenderingContext.prototype[name];
  WebGL2RenderingContext.prototype[name] = function (...words) {
    hasDrawn = true;
    return draw.apply(this, words);
  };
}
(function count() {
  if (hasDrawn) window.pictures += 1;
  hasDrawn = false;
  requestAnimationFrame(count);
})();
"""


class Robot(zbot.Node):
    """Node that publishes the scene."""

    def __init__(self, context: zbot.Context, parts: tuple[str, ...], mesh: Path) -> None:
        super().__init__("robot", context=context)
        self._started_s = time.monotonic()
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        if "frames" in parts:
            self._tf = self.create_publisher(TFMessage, "/tf", 10)
            self._links = TFMessage(transforms=[_link(number) for number in range(FRAMES)])
            self.create_timer(1 / 50, self.move)
        if "robot" in parts:
            robot = self.create_publisher(String, "/robot_description", latched)
            robot.publish(String(data=description(mesh)))
        if "cloud" in parts:
            self._cloud = self.create_publisher(PointCloud2, "/cloud", 2)
            points = np.random.default_rng(1).uniform(-5, 5, (POINTS, 3)).astype(np.float32)
            self._messages = [
                create_cloud_xyz32(Header(frame_id="base_link"), points + 0.01 * number)
                for number in range(10)
            ]
            self.create_timer(1 / 10, self.scan)

    def move(self) -> None:
        """Publish all transforms."""
        now = self.get_clock().now().to_msg()
        turn = time.monotonic() - self._started_s
        for number, link in enumerate(self._links.transforms):
            link.header.stamp = now
            link.transform.translation.z = 1 + 0.3 * math.sin(turn + number / 10)
        self._tf.publish(self._links)

    def scan(self) -> None:
        """Publish the cloud."""
        message = self._messages.pop(0)
        self._messages.append(message)
        message.header.stamp = self.get_clock().now().to_msg()
        self._cloud.publish(message)


def _link(number: int) -> TransformStamped:
    link = TransformStamped(child_frame_id=f"link_{number}")
    link.header.frame_id = "base_link"
    place = link.transform.translation
    place.x, place.y = float(number % LINKS - 10) / 2, float(number // LINKS - 5) / 2
    link.transform.rotation.w = 1.0
    return link


def description(mesh: Path) -> str:
    """Return a robot description whose links have the surface of a file."""
    shape = f"<geometry><mesh filename='file://{mesh}'/></geometry>"
    links = [f"<link name='link_{n}'><visual>{shape}</visual></link>" for n in range(LINKS)]
    joints = [
        f"<joint name='joint_{n}' type='floating'><parent link='base_link'/>"
        f"<child link='link_{n}'/></joint>"
        for n in range(LINKS)
    ]
    return f"<robot name='r'><link name='base_link'/>{''.join(links + joints)}</robot>"


def write_mesh(path: Path) -> None:
    """Write a surface with 5,120 triangles."""
    import trimesh  # noqa: PLC0415 - part of the extra

    ball = trimesh.creation.icosphere(subdivisions=4, radius=0.2)
    assert len(ball.faces) == 5120
    ball.export(path)


def publish(parts: str, mesh: str) -> None:
    """Publish the scene until the program ends."""
    with zbot.init(domain_id=_DOMAIN) as started:
        zbot.spin(Robot(started.context, tuple(filter(None, parts.split(","))), Path(mesh)))


@contextlib.contextmanager
def program(*words: str) -> Iterator[subprocess.Popen[str]]:
    """Run a program of Python until the end of the block."""
    process = subprocess.Popen(
        [sys.executable, *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        yield process
    finally:
        process.terminate()
        process.wait(10)


def address_of(view: subprocess.Popen[str]) -> str:
    """Return the address that `zbot view` prints."""
    assert view.stdout is not None
    for line in view.stdout:
        found = re.search(r"http://[\d.:]+", line)
        if found:
            return found[0]
    raise SystemExit("`zbot view` has ended")


def measure(browser: Browser, scene: str, mesh: Path, options: argparse.Namespace) -> str:
    """Return a row's figures."""
    parts = SCENES[scene]
    view_words = ("view", "--no-browser", "--port", "0")
    with (
        program("-m", "benchmarks.view", "--publish", ",".join(parts), "--mesh", str(mesh)),
        program("-m", "zbot_cli", "--domain", str(_DOMAIN), *view_words) as view,
    ):
        width, height = map(int, options.size.split("x"))
        page = browser.new_page(viewport={"width": width, "height": height})
        page.add_init_script(_COUNTER)
        page.set_default_timeout(_START_S * 1000)
        with relay(address_of(view)) as (address, received):
            page.goto(address + options.query)
            _show(page, parts)
            page.wait_for_timeout(5000)
            figures = _figures(page, psutil.Process(view.pid), received, options.seconds)
        if options.picture:
            page.screenshot(path=f"{options.picture}_{scene}.png")
        page.close()
    return figures


@contextlib.contextmanager
def relay(address: str) -> Iterator[tuple[str, list[int]]]:
    """Relay connections to an address. Yield the address of the relay, and the bytes so far."""
    received = [0]
    port = urlsplit(address).port

    async def take(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        inner_reader, inner_writer = await asyncio.open_connection("127.0.0.1", port)
        await asyncio.gather(
            _copy(reader, inner_writer, [0]), _copy(inner_reader, writer, received)
        )

    async def listen() -> None:
        server = await asyncio.start_server(take, "127.0.0.1", 0)
        found.put(server.sockets[0].getsockname()[1])
        await server.serve_forever()

    found: queue.SimpleQueue[int] = queue.SimpleQueue()
    threading.Thread(target=asyncio.run, args=(listen(),), daemon=True).start()
    yield f"http://127.0.0.1:{found.get()}/", received


async def _copy(
    reader: asyncio.StreamReader, writer: asyncio.StreamWriter, count: list[int]
) -> None:
    with contextlib.suppress(OSError), contextlib.closing(writer):
        while data := await reader.read(1 << 16):
            count[0] += len(data)
            writer.write(data)
            await writer.drain()


def _show(page: Page, parts: tuple[str, ...]) -> None:
    """Show what is not shown from the start, and wait until all is there."""
    page.get_by_label("Frames").wait_for()
    if "cloud" in parts:
        page.get_by_label("/cloud").check()
    if "frames" in parts:
        page.get_by_text(f"{FRAMES + 1} frames in one tree").wait_for()


def _figures(page: Page, view: psutil.Process, received: list[int], seconds: float) -> str:
    browser = _browser()
    drawn, used_s, size = page.evaluate("window.pictures"), _used_s(view), received[0]
    browser_s, start_s = _family_s(browser), time.monotonic()
    page.wait_for_timeout(seconds * 1000)
    passed_s = time.monotonic() - start_s
    pictures = page.evaluate("window.pictures") - drawn
    share = (_used_s(view) - used_s) / passed_s
    for_one_ms = (_family_s(browser) - browser_s) / max(pictures, 1) * 1000
    sent = (received[0] - size) / passed_s / 1000
    return f"{pictures / passed_s:.1f} | {for_one_ms:.0f} ms | {share:.0%} | {sent:,.0f} kB/s"


def _browser() -> psutil.Process:
    found = (one for one in psutil.Process().children(recursive=True) if "chrom" in one.name())
    return next(found)


def _family_s(process: psutil.Process) -> float:
    """Return the processor time of a process and of the processes that it started."""
    return sum(_used_s(one) for one in (process, *process.children(recursive=True)))


def _used_s(process: psutil.Process) -> float:
    times = process.cpu_times()
    return float(times.user + times.system)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--query", default="", help="the query of the address of the view")
    parser.add_argument("--picture", default="", help="the start of the names of pictures")
    parser.add_argument("--publish", help=argparse.SUPPRESS)
    parser.add_argument("--mesh", default="", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.publish is not None:
        publish(options.publish, options.mesh)
        return
    _print_table(options)


def _print_table(options: argparse.Namespace) -> None:
    from playwright.sync_api import sync_playwright  # noqa: PLC0415 - a program may only publish

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        mesh = Path(folder) / "ball.stl"
        write_mesh(mesh)
        path = shutil.which("chromium") or shutil.which("google-chrome")
        browser = play.chromium.launch(executable_path=path, args=[*_ARGUMENTS])
        print(f"load {os.getloadavg()[0]:.1f}, {options.size} pixels")
        print("| scene | pictures a second | browser, for one | server | sent |")
        print("|---|---|---|---|---|")
        for scene in options.scenes.split(","):
            print(f"| {scene} | {measure(browser, scene, mesh, options)} |", flush=True)
        browser.close()


if __name__ == "__main__":
    main()
