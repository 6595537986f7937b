"""Measure the simulator: its real-time factor, and its processor time.

Run: python -m benchmarks.simulation [--seconds 10]

Each row is a simulator in a process of its own. This process subscribes to all lidars and cameras.
A factor of 1 means that a second in the world takes a second. 100 % is one core.
"""

from __future__ import annotations

import argparse
import contextlib
import subprocess
import sys
import time
from typing import TYPE_CHECKING, Any

import psutil

import zbot
from zbot.qos import qos_profile_sensor_data

from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image, LaserScan

if TYPE_CHECKING:
    from collections.abc import Iterator

#: The robots of each row, and whether their cameras are subscribed, too.
ROWS = (
    ("one robot, lidar", 1, False),
    ("one robot, lidar and camera", 1, True),
    ("twenty robots, lidars", 20, False),
)
_DOMAIN = 77
_START_S = 60.0


class Listener(zbot.Node):
    """Node that counts what the simulator publishes."""

    def __init__(self, context: zbot.Context, robots: int, *, has_cameras: bool) -> None:
        super().__init__("listener", context=context)
        self.clock_s = 0.0
        self.scans = self.images = 0
        names = [""] if robots == 1 else [f"/robot{number + 1}" for number in range(robots)]
        self.create_subscription(Clock, "/clock", self.note, 10)
        for name in names:
            topic, qos = f"{name}/scan", qos_profile_sensor_data
            self.create_subscription(LaserScan, topic, self.count_scan, qos)
            if has_cameras:
                topic = f"{name}/camera/image_raw"
                self.create_subscription(Image, topic, self.count_image, qos)

    def note(self, message: Clock) -> None:
        """Store the time in the world."""
        self.clock_s = message.clock.sec + message.clock.nanosec / 1e9

    def count_scan(self, _message: Any) -> None:
        """Count a scan."""
        self.scans += 1

    def count_image(self, _message: Any) -> None:
        """Count an image."""
        self.images += 1


@contextlib.contextmanager
def simulator(robots: int, rate: str) -> Iterator[psutil.Process]:
    """Run `zbot sim` in a process."""
    words = ["sim", "warehouse", "--headless", "--robots", str(robots), "--rate", rate]
    command = [sys.executable, "-m", "zbot_cli", "--domain", str(_DOMAIN), *words]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    try:
        yield psutil.Process(process.pid)
    finally:
        process.terminate()
        process.wait(10)


def measure(robots: int, *, has_cameras: bool, rate: str, seconds: float) -> str:
    """Return a row's figures: factor, processor time, and scans and images a second."""
    with (
        zbot.init(domain_id=_DOMAIN) as started,
        simulator(robots, rate) as process,
    ):
        node = Listener(started.context, robots, has_cameras=has_cameras)
        end_s = time.monotonic() + _START_S
        while node.scans < 2 * robots and time.monotonic() < end_s:
            zbot.spin_once(node)
        clock_s, scans, images = node.clock_s, node.scans, node.images
        used_s, start_s = _used_s(process), time.monotonic()
        while time.monotonic() - start_s < seconds:
            zbot.spin_once(node)
        passed_s = time.monotonic() - start_s
        factor = (node.clock_s - clock_s) / passed_s
        share = (_used_s(process) - used_s) / passed_s
        scans, images = node.scans - scans, node.images - images
    per_scan, per_image = scans / passed_s / robots, images / passed_s / robots
    return f"{factor:.3f} | {share:.0%} | {per_scan:.1f} | {per_image:.1f}"


def _used_s(process: psutil.Process) -> float:
    times = process.cpu_times()
    return float(times.user + times.system)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0)
    seconds = parser.parse_args().seconds
    print("| world | --rate | factor | processor | scans/s | images/s |")
    print("|---|---|---|---|---|---|")
    for rate in ("1", "max"):
        for name, robots, has_cameras in ROWS:
            figures = measure(robots, has_cameras=has_cameras, rate=rate, seconds=seconds)
            print(f"| {name} | {rate} | {figures} |", flush=True)


if __name__ == "__main__":
    main()
