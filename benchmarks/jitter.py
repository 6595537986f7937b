"""How late timers call, alone and beside a flood of messages in two other processes.

The yardstick is a plain Python thread that sleeps with `time.sleep` until the next period.
"""

from __future__ import annotations

from contextlib import ExitStack
from functools import partial
from typing import TYPE_CHECKING

from benchmarks.contestant import ZBOT, Contestant, Program, environment
from benchmarks.interleaving import Row, Sample, measured, percentile

if TYPE_CHECKING:
    from benchmarks.report import Report

THREAD = Contestant("plain thread", "raw_program.py")
RATES = {100: "100 Hz", 1000: "1 kHz"}
SECONDS = 3.0
_FLOOD_S = 60.0  # longer than a measurement
_SIZE = 64


def lateness(contestant: Contestant, rate: float, *, with_flood: bool) -> Sample:
    """Return percentiles of |actual - planned| in microseconds."""
    with ExitStack() as stack:
        if with_flood:
            env = environment(ZBOT)
            sink = stack.enter_context(Program(ZBOT, "sink", env, kind=_SIZE))
            flood = stack.enter_context(Program(ZBOT, "flood", env, kind=_SIZE, seconds=_FLOOD_S))
            flood.read()
            sink.ask(until=1)
            flood.tell()
        options = {"rate": rate, "seconds": SECONDS}
        with Program(contestant, "timer", environment(contestant), **options) as program:
            late = [abs(delay) / 1000 for delay in program.read()["late"]]
    return {"p50": percentile(late, 0.5), "p99": percentile(late, 0.99), "max": max(late)}


def rows() -> list[Row]:
    return [
        Row(f"timer at {label}, {beside}", partial(lateness, rate=rate, with_flood=with_flood))
        for with_flood, beside in ((False, "alone"), (True, "beside a flood"))
        for rate, label in RATES.items()
    ]


def table(report: Report, rounds: int) -> None:
    report.head(
        "Jitter of timers (microseconds that a call is late)",
        *("timer", "contestant", "p50", "p99", "max"),
    )
    for row in rows():
        cells = measured(row, [THREAD, ZBOT], rounds)
        for name in cells.names():
            values = [cells.median(name, metric) for metric in ("p50", "p99", "max")]
            label = row.label.removeprefix("timer at ")
            report.row(label, name, *(f"{value:.0f}" for value in values))
