"""Measure `zbot bridge dds`: the latency that it adds, messages a second, and processor time.

Run: ZBOT_ROS2_PYTHON=path/to/python python -m benchmarks.bridge [--write] [--soak MINUTES]

The Python needs zbot and a genuine rclpy: pip install -e '.[ros2]'. The publisher is a genuine
node, the receiver is a node of zbot. All are on this machine. A lost message was overwritten in a
queue.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import platform
import statistics
import subprocess
import sys
import threading
import time
from datetime import datetime, timezone
from pathlib import Path
from typing import TYPE_CHECKING, Any

import zbot
from benchmarks.contestant import PROGRAMS, ROS2_PYTHON
from zbot import Context, Node, SingleThreadedExecutor
from zbot.interfaces import get_message

if TYPE_CHECKING:
    from collections.abc import Iterator

DOMAIN = 77
SECONDS = 10.0
RESULTS = Path(__file__).parent / "BRIDGE.md"
TYPES = {"String": "std_msgs", "Imu": "sensor_msgs", "Image": "sensor_msgs"}
_TICKS = os.sysconf("SC_CLK_TCK") if hasattr(os, "sysconf") else 100
#: what is sent: title, type, topics, hertz, bytes
CASES = [
    ("Imu, 100 Hz", "Imu", 1, 100, 0),
    ("Imu, 1 kHz", "Imu", 1, 1000, 0),
    ("String, 64 B, 2 kHz", "String", 1, 2000, 64),
    ("String, 64 B, 5 kHz", "String", 1, 5000, 64),
    ("String, 64 B, 10 kHz", "String", 1, 10000, 64),
    ("Image, 1 MB, 30 Hz", "Image", 1, 30, 1_000_000),
    ("String, 100 topics, 10 Hz each", "String", 100, 10, 64),
    ("String, 200 topics, 10 Hz each", "String", 200, 10, 64),
]


def environment() -> dict[str, str]:
    leaks = {"LD_LIBRARY_PATH", "LD_PRELOAD", "_ROS_WHEELS_BOOTSTRAP_COMPLETE"}
    kept = {name: value for name, value in os.environ.items() if name not in leaks}
    number = str(DOMAIN)
    own = {"ROS_DOMAIN_ID": number, "ZBOT_DOMAIN_ID": number}
    return kept | own | {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


@contextlib.contextmanager
def program(*words: str) -> Iterator[subprocess.Popen[str]]:
    """Run a program with the genuine rclpy for the length of a block."""
    command = [ROS2_PYTHON, *words]
    options: dict[str, Any] = {"env": environment(), "encoding": "utf-8"}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def line_with(process: subprocess.Popen[str], text: str) -> str:
    assert process.stdout is not None
    lines = []
    for line in process.stdout:
        lines.append(line)
        if text in line:
            return line
    raise SystemExit(f"{text!r} never came:\n{''.join(lines)}")


def cpu_s(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICKS


class Receiver:
    """Node of zbot that notes the delay of each message."""

    def __init__(self, kind: str, topics: int) -> None:
        self.delays_ns: list[int] = []
        self.context = Context()
        self.context.init([], domain_id=DOMAIN)
        self.node = Node("receiver", context=self.context)
        self._has_header = kind != "String"
        cls = get_message(f"{TYPES[kind]}/msg/{kind}")
        for index in range(topics):
            self.node.create_subscription(cls, f"/m{index}", self._take, 100)
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.thread = threading.Thread(target=self.executor.spin)
        self.thread.start()

    def _take(self, message: Any) -> None:
        now = time.monotonic_ns()
        if self._has_header:
            stamp = message.header.stamp
            self.delays_ns.append(now - stamp.sec * 10**9 - stamp.nanosec)
        else:
            self.delays_ns.append(now - int(message.data.rstrip(".")))

    def close(self) -> None:
        self.executor.shutdown(5)
        self.thread.join()
        self.context.shutdown()


def measured(
    kind: str, topics: int, hertz: int, size: int, seconds: float = SECONDS
) -> dict[str, float]:
    words = ("publish", kind, str(topics), str(hertz), str(seconds), str(size))
    receiver = Receiver(kind, topics)
    try:
        with (
            program("-m", "zbot_cli", "bridge", "dds") as bridge,
            program(str(PROGRAMS / "bridge_robot.py"), *words) as robot,
        ):
            line_with(bridge, "carrying")
            line_with(robot, "begin")
            before = cpu_s(bridge.pid)
            told = json.loads(line_with(robot, "sent"))
            used = cpu_s(bridge.pid) - before
            time.sleep(0.5)
            delays = sorted(receiver.delays_ns)
    finally:
        receiver.close()
    return {
        "rate": told["sent"] / told["took_s"],
        "lost": told["sent"] - len(delays),
        "p50": statistics.median(delays) / 1e6,
        "p99": delays[int(len(delays) * 0.99)] / 1e6,
        "cpu": 100 * used / told["took_s"],
    }


def directly(kind: str, hertz: int, size: int) -> float:
    """Return the median delay (ms) between two genuine nodes, without a bridge."""
    script = str(PROGRAMS / "bridge_robot.py")
    with (
        program(script, "receive", kind, str(SECONDS + 5)) as receiver,
        program(script, "publish", kind, "1", str(hertz), str(SECONDS), str(size)),
    ):
        delays: list[int] = json.loads(line_with(receiver, "["))
    return statistics.median(delays) / 1e6 if delays else float("nan")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help=f"write {RESULTS.name}")
    parser.add_argument("--soak", type=float, help="only carry 200 topics for so many minutes")
    options = parser.parse_args()
    if not ROS2_PYTHON:
        sys.exit("set ZBOT_ROS2_PYTHON to a Python with zbot and a genuine rclpy")
    if options.soak:
        print(measured("String", 200, 10, 64, options.soak * 60))
        return
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"
    introduction = (
        f"{datetime.now(timezone.utc):%Y-%m-%d}, {machine}, Python {platform.python_version()}, "
        f"zbot {zbot.__version__}. A node of ROS 2 publishes for {SECONDS:.0f} s, and a node of "
        "zbot receives. *direct* is the time between two nodes of ROS 2 without the bridge. *CPU* "
        "is the CPU time of the bridge, in percent of one core.\n"
    )
    lines = [
        "# The bridge to ROS 2 over DDS, measured\n",
        introduction,
        "| messages | sent /s | lost | p50 ms | p99 ms | direct p50 ms | CPU % |",
        "|---|---|---|---|---|---|---|",
    ]
    print("\n".join(lines), flush=True)
    for title, kind, topics, hertz, size in CASES:
        found = measured(kind, topics, hertz, size)
        direct = f"{directly(kind, hertz, size):.2f}" if topics == 1 else "-"
        lines.append(
            f"| {title} | {found['rate']:,.0f} | {found['lost']:.0f} | {found['p50']:.2f} "
            f"| {found['p99']:.2f} | {direct} | {found['cpu']:.0f} |"
        )
        print(lines[-1], flush=True)
    if options.write:
        RESULTS.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
