"""Measure zbot beside raw eclipse-zenoh and, where it is installed, rclpy.

Run: make bench                                  (or: python -m benchmarks --quick)
     python -m benchmarks --compare CHECKOUT     this checkout beside another one
     ZBOT_ROS2_PYTHON=path/to/python names an interpreter with the wheels of ROS 2.
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
import time
from datetime import datetime, timezone
from importlib.metadata import version
from pathlib import Path

import zbot
from benchmarks import (
    busy_waiting,
    cdr,
    comparison,
    delays,
    dialect,
    jitter,
    nodes,
    picture,
    round_trips,
    start,
    throughput,
)
from benchmarks.interleaving import Disturbances
from benchmarks.report import Report

HERE = Path(__file__).parent
PICTURE = "growth.svg"
FAIRNESS = (
    "*raw* is eclipse-zenoh without zbot, with the fastest of its ways to receive: a callback in "
    "the network thread (direct), a callback in a thread of the binding (thread), or a queue that "
    "the program reads (channel). raw and zbot have the same settings of the session, length of "
    "queues, shared memory for large messages, reliability, congestion control (block one way, "
    "drop for round trips), encoding, attachment, and number of bytes. zbot also encodes, decodes "
    "and runs an executor. After a short wait, a thread of zbot polls before it sleeps. *zbot, "
    "sleeps at once* does not poll, and *raw, channel that polls* never sleeps. CPU time is the "
    "sum of both processes."
)


def introduce(report: Report, rounds: int) -> None:
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"
    report.say("# Benchmark results\n")
    report.say(
        f"{datetime.now(timezone.utc):%Y-%m-%d}, {machine}, Python {platform.python_version()}, "
        f"zbot {zbot.__version__}, eclipse-zenoh {version('eclipse-zenoh')}. Each value is the "
        f"median of {rounds} run{'s or more' * (rounds > 1)}. The contestants take turns.\n"
    )
    report.say(FAIRNESS)


def results(report: Report, options: argparse.Namespace) -> None:
    """Print all tables, and write the picture if it is wanted."""
    rounds = 1 if options.quick else 3
    introduce(report, rounds)
    throughput.types_table(report, rounds)
    points = throughput.sizes_table(report, rounds)
    report.say(f"\n![messages per second against the size of a message]({PICTURE})")
    round_trips.trips_table(report, rounds)
    round_trips.service_table(report, rounds)
    delays.table(report, rounds)
    busy_waiting.table(report, rounds)
    cdr.table(report)
    dialect.table(report, rounds)
    jitter.table(report, rounds)
    if platform.system() == "Linux":
        nodes.table(report, crowds(options))
    start.table(report, 3 * rounds)
    report.say(
        f"\nOther programs disturbed runs {Disturbances.repeated + Disturbances.kept} times. "
        f"{Disturbances.kept} disturbed runs are in the tables, and the others were repeated."
    )
    if options.write:
        drawn = picture.draw("Messages per second, two processes of one machine", points)
        (HERE / PICTURE).write_text(drawn, encoding="utf-8")
        (HERE / "RESULTS.md").write_text("\n".join(report.lines) + "\n", encoding="utf-8")


def crowds(options: argparse.Namespace) -> tuple[int, ...]:
    if options.quick:
        return nodes.CROWDS[:2]
    return nodes.FULL_CROWDS if options.full else nodes.CROWDS


def compare(report: Report, options: argparse.Namespace) -> None:
    """Print the ratios between two checkouts.

    Raises:
        SystemExit: The folder is not a checkout, or no row has the wanted words.
    """
    other = options.compare.resolve()
    if not (other / "zbot" / "__init__.py").is_file():
        sys.exit(f"error: {other} has no folder zbot: name a checkout of zbot")
    rows = [row for row in comparison.rows(crowds(options)) if options.only in row.label]
    if not rows:
        sys.exit(
            f"error: no row has {options.only!r} in its name: leave out --only to see the names"
        )
    comparison.compare(report, other, rows, 1 if options.quick else 5)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="one round, at most ten nodes")
    parser.add_argument("--full", action="store_true", help="also 200 nodes, which takes 8 GB")
    parser.add_argument("--write", action="store_true", help=f"write RESULTS.md and {PICTURE}")
    parser.add_argument("--compare", type=Path, metavar="CHECKOUT", help="another checkout of zbot")
    parser.add_argument(
        "--only", default="", metavar="WORDS", help="rows to compare, by their names"
    )
    options = parser.parse_args()
    begun, report = time.monotonic(), Report()
    if options.compare is None:
        results(report, options)
    else:
        compare(report, options)
    print(f"\n{time.monotonic() - begun:.0f} s", file=sys.stderr)


if __name__ == "__main__":
    main()
