"""Round trips and service calls between two processes: their time, and CPU time of each message."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from benchmarks.contestant import (
    ASLEEP,
    POLLING,
    RAW_WAYS,
    RCLPY,
    ZBOT,
    Contestant,
    Program,
    data_options,
    environment,
)
from benchmarks.interleaving import Row, Sample, measured, percentile

if TYPE_CHECKING:
    from collections.abc import Sequence

    from benchmarks.report import Report

SIZES = {64: ("64 B", 4000), 4096: ("4 KiB", 4000), 1_000_000: ("1 MB", 600)}
CALLS = 2000
_HEADER_BYTES = 40  # about what zbot's encoding adds to the bytes of an array
_REQUEST_BYTES = 10  # AddTwoInts in zbot's encoding
_QUEUE = 10


def _times(trips: Sequence[float]) -> Sample:
    shares = {"p50": 0.5, "p99": 0.99, "p99.9": 0.999}
    return {name: percentile(trips, share) / 1000 for name, share in shares.items()}


def round_trip(contestant: Contestant, size: int, count: int) -> Sample:
    """Return percentiles in microseconds, and CPU microseconds of a message in both processes."""
    env = environment(contestant)
    data = data_options(contestant, size, size=size + _HEADER_BYTES, queue=_QUEUE)
    with (
        Program(contestant, "echo", env, **data) as echo,
        Program(contestant, "ping", env, count=count, **data) as ping,
    ):
        ping.read()
        cpu = echo.ask()["cpu"]
        done = ping.ask()
        used = done["cpu"] + echo.ask()["cpu"] - cpu
    return {**_times(done["trips"]), "cpu": used / (2 * count) * 1e6}


def service_call(contestant: Contestant) -> Sample:
    env = environment(contestant)
    size = {"size": _REQUEST_BYTES} if contestant.is_raw else {}
    with (
        Program(contestant, "server", env, **size),
        Program(contestant, "caller", env, count=CALLS, **size) as caller,
    ):
        return _times(caller.read()["trips"])


def rows() -> list[Row]:
    return [
        Row(f"round trip of {label}", partial(round_trip, size=size, count=count))
        for size, (label, count) in SIZES.items()
    ]


def service_row() -> Row:
    return Row("service call", service_call)


def trips_table(report: Report, rounds: int) -> None:
    report.head(
        "Round trip, two processes (microseconds)",
        *("size", "contestant", "p50", "p99", "p99.9", "p50 / raw", "CPU a message"),
    )
    for row in rows():
        cells = measured(row, [*RAW_WAYS, POLLING, ZBOT, ASLEEP, *RCLPY], rounds)
        raw = cells.median(cells.best(RAW_WAYS, "p50"), "p50")
        for name in cells.names():
            times = [cells.median(name, metric) for metric in ("p50", "p99", "p99.9")]
            report.row(
                row.label.rpartition(" of ")[2],
                name,
                *(f"{time:.0f}" for time in times),
                f"{times[0] / raw:.2f}",
                f"{cells.median(name, 'cpu'):.0f}",
            )


def service_table(report: Report, rounds: int) -> None:
    report.head(
        "Service call, two processes (microseconds)", "contestant", "p50", "p99", "p50 / raw"
    )
    ways = RAW_WAYS[:2]  # a channel of queries has no use in zbot
    cells = measured(service_row(), [*ways, ZBOT, ASLEEP, *RCLPY], rounds)
    raw = cells.median(cells.best(ways, "p50"), "p50")
    for name in cells.names():
        p50, p99 = cells.median(name, "p50"), cells.median(name, "p99")
        report.row(name, f"{p50:.0f}", f"{p99:.0f}", f"{p50 / raw:.2f}")
