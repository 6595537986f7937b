"""A student's view over a network of its own: the teacher sees it within the budget."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

import pytest

from zbot.view.arrangement.arrangement import Arrangement, DisplayChoice
from zbot.view.arrangement.rviz_writer import rviz_text

pytest.importorskip("viser", reason='the view needs viser: pip install "zbot[view]"')

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.classroom.testbed import LanTestbed

#: A cloud of 100,000 points and a scan 10 times a second, and 50 frames 50 times a second.
ROBOT = """
import math, time
import numpy as np
import zbot
from zbot.libraries.point_cloud import create_cloud_xyz32
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import LaserScan, PointCloud2
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

zbot.init()
node = zbot.Node("robot")
points = np.random.default_rng(1).uniform(-5, 5, (100_000, 3)).astype(np.float32)
clouds = [create_cloud_xyz32(Header(frame_id="base"), points + 0.01 * n) for n in range(5)]
send = {kind: node.create_publisher(kind, topic, 5) for kind, topic in (
    (PointCloud2, "/cloud"), (LaserScan, "/scan"), (TFMessage, "/tf"))}

def look():
    clouds.append(clouds.pop(0))
    now = node.get_clock().now().to_msg()
    clouds[0].header.stamp = now
    send[PointCloud2].publish(clouds[0])
    scan = LaserScan(angle_increment=math.tau / 360, range_min=0.1, range_max=10.0,
                     ranges=[2 + math.sin(time.time() + n) for n in range(360)])
    scan.header.frame_id, scan.header.stamp = "base", now
    send[LaserScan].publish(scan)

def move():
    links = []
    for number in range(50):
        link = TransformStamped(child_frame_id=f"frame_{number}")
        link.header.frame_id, link.header.stamp = "base", node.get_clock().now().to_msg()
        link.transform.translation.x = math.sin(time.time() + number)
        link.transform.rotation.w = 1.0
        links.append(link)
    send[TFMessage].publish(TFMessage(transforms=links))

node.create_timer(0.1, look)
node.create_timer(0.02, move)
print("ready", flush=True)
zbot.spin(node)
"""
#: Reads all that the view sends, as a browser does. After the first drawings and the plan of the
#: budget it prints a line, and another one some seconds later.
BROWSER = """
import asyncio, sys, time, urllib.request
import viser, websockets

class Stay(urllib.request.HTTPRedirectHandler):
    def redirect_request(self, *words):
        return None

address = sys.argv[1]
try:
    urllib.request.build_opener(Stay).open(address)
except urllib.error.HTTPError as answer:
    cookie = answer.headers["Set-Cookie"].split(";")[0]

async def read():
    origin = address.split("/?")[0]
    options = {"subprotocols": [f"viser-v{viser.__version__}"], "max_size": None}
    headers = {"Cookie": cookie}
    async with websockets.connect(
        origin.replace("http", "ws"), origin=origin, additional_headers=headers, **options
    ) as socket:
        print("open", flush=True)
        await read_for(socket)
        print("begin", flush=True)
        print("read for", await read_for(socket), flush=True)
        await read_for(socket)

async def read_for(socket):
    begun = time.monotonic()
    async for _ in socket:
        passed = time.monotonic() - begun
        if passed > 8:
            return passed

asyncio.run(read())
"""
BUDGET = 200_000  #: bytes a second


def test_a_view_over_the_network_keeps_its_budget(
    make_testbed: Callable[[int], LanTestbed],
) -> None:
    testbed = make_testbed(1)
    teacher, laptop = testbed.teacher, testbed.laptops[0]
    kinds = (("TF", ""), ("LaserScan", "/scan"), ("PointCloud2", "/cloud"))
    shown = tuple(DisplayChoice(kind, kind, topic) for kind, topic in kinds)
    (laptop.home / "all.rviz").write_text(rviz_text(Arrangement(shown, "base")))
    (laptop.home / "robot.py").write_text(ROBOT)
    (teacher.home / "browser.py").write_text(BROWSER)
    laptop.start(sys.executable, "robot.py").wait_for("ready")
    view = laptop.start("zbot", "view", "--host", "0.0.0.0", "--no-browser", "all.rviz")
    printed = view.wait_for(f"zbot view: http://{laptop.address}", 60)
    parts = urlsplit(printed.partition("zbot view: ")[2])
    address = f"http://{laptop.address}:{parts.port}/?{parts.query}"
    browser = teacher.start(sys.executable, "browser.py", address)
    browser.wait_for("begin", 60)
    before = laptop.traffic()
    seconds = float(browser.wait_for("read for", 60).rpartition(" ")[2])
    sent = (laptop.traffic() - before).sent_bytes / seconds
    print(f"a view over the network: {sent / 1000:.0f} kB/s")
    assert 20_000 < sent < BUDGET
