"""Measure zbot, raw eclipse-zenoh and, where it is installed, rclpy; print medians and ratios.

Run: make bench            (or: python -m benchmarks --quick)
     ZBOT_ROS2_PYTHON=path/to/python names an interpreter with the wheels of ROS 2.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import platform
import socket
import statistics
import subprocess
import sys
import time
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path

import zbot
from benchmarks.contestants import SERVICES, SOURCES
from zbot.transport.config import MEETING_PORT
from zbot.wire.codec import codec_for

from example_interfaces.srv import AddTwoInts

SIZES = ((64, "64 B"), (4096, "4 KiB"), (1_000_000, "1 MB"))
ROS2_PYTHON = os.environ.get("ZBOT_ROS2_PYTHON", "")
_DOMAIN = itertools.cycle(range(150, 230))
_IDLE_S = 10.0


class Report:
    """Lines of the results file, which are also printed."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def say(self, line: str = "") -> None:
        print(line, flush=True)
        self.lines.append(line)


def is_free(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) != 0


def environment(name: str) -> dict[str, str]:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    domain = str(next(number for number in _DOMAIN if is_free(MEETING_PORT + number)))
    env = {**os.environ, "BENCH_PORT": port, "ZBOT_DOMAIN_ID": domain}
    if name == "rclpy":
        # rclpy's interpreter starts itself again with these; zbot's processes must not inherit them.
        env |= {"ROS_DOMAIN_ID": domain[-2:], "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    return env


def python(name: str) -> str:
    return ROS2_PYTHON if name == "rclpy" else sys.executable


def run_pair(name: str, background: str, foreground: str, size: int, count: int) -> str:
    env = environment(name)
    words = [python(name), "-c"]
    # Output of a contestant at its end is not a result.
    helper = subprocess.Popen(
        [*words, background, str(size), str(count)], env=env, stderr=subprocess.DEVNULL
    )
    try:
        done = subprocess.run(
            [*words, foreground, str(size), str(count)],
            env=env,
            capture_output=True,
            text=True,
            timeout=180,
            check=True,
        )
    finally:
        helper.terminate()
        helper.wait(10)
    return done.stdout.splitlines()[-1]


def round_trip(name: str, size: int, count: int) -> list[float]:
    echo, ping, _, _ = SOURCES[name]
    return [trip / 1000 for trip in json.loads(run_pair(name, echo, ping, size, count))]


def throughput(name: str, size: int, count: int) -> dict[str, float]:
    _, _, sink, flood = SOURCES[name]
    return json.loads(run_pair(name, flood, sink, size, count))


def contestants() -> list[str]:
    return ["raw", "zbot", "rclpy"] if ROS2_PYTHON else ["raw", "zbot"]


def latency_table(report: Report, rounds: int) -> None:
    report.say("\n## Round trip, two processes (microseconds)\n")
    report.say("| size | contestant | p50 | p99 | p50 / raw |\n|---|---|---|---|---|")
    for size, label in SIZES:
        count = 300 if size > 100_000 else 2000
        trips: dict[str, list[list[float]]] = {name: [] for name in contestants()}
        for _ in range(rounds):  # interleaved: other load affects all contestants
            for name in trips:
                trips[name].append(sorted(round_trip(name, size, count)))
        raw = statistics.median(statistics.median(run) for run in trips["raw"])
        for name, runs in trips.items():
            p50 = statistics.median(statistics.median(run) for run in runs)
            p99 = statistics.median(run[int(len(run) * 0.99)] for run in runs)
            report.say(f"| {label} | {name} | {p50:.0f} | {p99:.0f} | {p50 / raw:.2f} |")


def service_table(report: Report, rounds: int) -> None:
    report.say("\n## Service call, two processes (microseconds)\n")
    report.say("| contestant | p50 | p99 | p50 / raw |\n|---|---|---|---|")
    request = codec_for(AddTwoInts.Request).encode(AddTwoInts.Request(a=1, b=2))
    trips: dict[str, list[list[float]]] = {name: [] for name in contestants()}
    for _ in range(rounds):
        for name in trips:
            server, caller = SERVICES[name]
            output = run_pair(name, server, caller, len(request), 2000)
            trips[name].append(sorted(trip / 1000 for trip in json.loads(output)))
    raw = statistics.median(statistics.median(run) for run in trips["raw"])
    for name, runs in trips.items():
        p50 = statistics.median(statistics.median(run) for run in runs)
        p99 = statistics.median(run[int(len(run) * 0.99)] for run in runs)
        report.say(f"| {name} | {p50:.0f} | {p99:.0f} | {p50 / raw:.2f} |")


def throughput_table(report: Report, rounds: int) -> None:
    report.say("\n## One way, reliable keep-all, two processes (messages per second received)\n")
    report.say("| size | contestant | rate | MB/s | lost | rate / raw |\n|---|---|---|---|---|---|")
    for size, label in SIZES:
        count = 1500 if size > 100_000 else 300_000
        runs: dict[str, list[dict[str, float]]] = {name: [] for name in contestants()}
        # The rate of raw Zenoh varies by a factor of two between runs: it has more runs. That of
        # rclpy does not vary, and a run of it takes a minute.
        for turn in range(3 * rounds):
            for name in runs if turn < rounds else ("raw", "zbot"):
                try:
                    runs[name].append(throughput(name, size, count))
                except subprocess.CalledProcessError as exc:
                    if name != "rclpy":  # its interpreter sometimes ends without a message
                        raise
                    print(f"rclpy ended with {exc.returncode}", file=sys.stderr)
        rates = {
            name: statistics.median(run["rate"] for run in found)
            for name, found in runs.items()
            if found
        }
        for name, rate in rates.items():
            lost = "most" if name == "rclpy" else sum(run["lost"] for run in runs[name])
            report.say(
                f"| {label} | {name} | {rate:,.0f} | {rate * size / 1e6:,.0f} | {lost} | "
                f"{rate / rates['raw']:.2f} |"
            )


FIRST = """
import zbot
from std_msgs.msg import String
with zbot.init():
    zbot.Node('first').create_publisher(String, 'first', 10).publish(String(data='x'))
"""
IDLE = """
import zbot
from std_msgs.msg import String
with zbot.init():
    node = zbot.Node('idle_{number}')
    node.create_publisher(String, 'out', 10)
    node.create_subscription(String, 'in', print, 10)
    zbot.spin(node)
"""


def timed(command: list[str], env: dict[str, str]) -> float:
    begun = time.perf_counter()
    subprocess.run(command, env=env, check=True, stdout=subprocess.DEVNULL)
    return (time.perf_counter() - begun) * 1000


def start_table(report: Report, rounds: int) -> None:
    report.say("\n## Start (milliseconds, whole processes)\n")
    env = environment("zbot")
    command = [sys.executable, "-m", "zbot_cli"]
    help_ms = statistics.median(timed([*command, "--help"], env) for _ in range(rounds * 3))
    bare_ms = statistics.median(timed([sys.executable, "-c", ""], env) for _ in range(rounds * 3))
    report.say("| what | median |\n|---|---|")
    report.say(f"| bare python | {bare_ms:.0f} |\n| `zbot --help` | {help_ms:.0f} |")
    os.environ["ZBOT_DOMAIN_ID"] = env["ZBOT_DOMAIN_ID"]
    arrived: list[float] = []
    with zbot.init(args=[]):
        node = zbot.Node("stopwatch")
        from std_msgs.msg import String  # noqa: PLC0415 - importable after zbot

        node.create_subscription(String, "first", lambda _: arrived.append(time.perf_counter()), 10)
        took = []
        for _ in range(rounds * 3):
            arrived.clear()
            begun = time.perf_counter()
            with subprocess.Popen([sys.executable, "-c", FIRST], env=env):
                while not arrived:
                    zbot.spin_once(node, timeout_sec=5)
            took.append((arrived[0] - begun) * 1000)
    report.say(
        f"| process start to first message at a subscriber | {statistics.median(took):.0f} |"
    )


def resident_mb(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    return int(status.split("VmRSS:")[1].split()[0]) / 1024


def cpu_seconds(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def crowd_table(report: Report, crowds: tuple[int, ...]) -> None:
    report.say("\n## Nodes on one machine\n")
    report.say(
        "| nodes | `zbot topic list` ms | `zbot node list` complete at once | RSS MB | CPU % a node |\n"
        "|---|---|---|---|---|"
    )
    for crowd in crowds:
        env = environment("zbot")
        nodes = [
            subprocess.Popen([sys.executable, "-c", IDLE.format(number=number)], env=env)
            for number in range(crowd)
        ]
        try:
            report.say(crowd_row(crowd, nodes, env))
        finally:
            for node in nodes:
                node.terminate()
            for node in nodes:
                node.wait(10)


def crowd_row(crowd: int, nodes: list[subprocess.Popen[bytes]], env: dict[str, str]) -> str:
    command = [sys.executable, "-m", "zbot_cli"]

    def count() -> int:
        words = [*command, "node", "list", "--count-nodes"]
        return int(
            subprocess.run(words, env=env, capture_output=True, text=True, check=True).stdout
        )

    while count() < crowd:
        time.sleep(0.2)
    lists = statistics.median(timed([*command, "topic", "list"], env) for _ in range(5))
    complete = all(count() == crowd for _ in range(5))
    time.sleep(2)
    before = [cpu_seconds(node.pid) for node in nodes]
    time.sleep(_IDLE_S)
    used = statistics.median(
        (cpu_seconds(node.pid) - begun) / _IDLE_S * 100
        for node, begun in zip(nodes, before, strict=True)
    )
    memory = statistics.median(resident_mb(node.pid) for node in nodes)
    return f"| {crowd} | {lists:.0f} | {'yes' if complete else 'no'} | {memory:.0f} | {used:.2f} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="one round, fewer nodes")
    parser.add_argument("--write", action="store_true", help="write benchmarks/RESULTS.md")
    options = parser.parse_args()
    rounds = 1 if options.quick else 3
    report = Report()
    report.say("# Benchmark results\n")
    report.say(
        f"{datetime.now(timezone.utc):%Y-%m-%d}, {platform.system()} {platform.machine()}, "
        f"{os.cpu_count()} cores, Python {platform.python_version()}, zbot {zbot.__version__}, "
        f"eclipse-zenoh {version('eclipse-zenoh')}. Each value is the median of {rounds} interleaved "
        f"runs ({3 * rounds} runs for rates of messages and for starts)."
    )
    latency_table(report, rounds)
    service_table(report, rounds)
    throughput_table(report, rounds)
    start_table(report, rounds)
    if platform.system() == "Linux":
        crowd_table(report, (10,) if options.quick else (1, 10, 40))
    if options.write:
        target = Path(__file__).parent / "RESULTS.md"
        target.write_text("\n".join(report.lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
