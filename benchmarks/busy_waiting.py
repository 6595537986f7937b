"""CPU time of messages at a fixed rate, with and without zbot's busy waiting.

A zbot thread whose last wait was short polls before it sleeps (zbot/threads/wakeup.py). zbot has
no setting that switches this off, so the measured program replaces the method.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from benchmarks.contestant import (
    ASLEEP,
    RAW_WAYS,
    ZBOT,
    Contestant,
    Program,
    data_options,
    environment,
)
from benchmarks.interleaving import Row, Sample, measured

if TYPE_CHECKING:
    from benchmarks.report import Report

RATES = {100: "100 Hz", 1000: "1 kHz", 5000: "5 kHz"}
SECONDS = 1.5
_SIZE = 64
_HEADER_BYTES = 40
_QUEUE = 256


def steady(
    contestant: Contestant, rate: float, kind: str | int = _SIZE, size: int = _SIZE + _HEADER_BYTES
) -> Sample:
    """Return the CPU percent of a publisher that sends at a rate, and of its subscriber."""
    env = environment(contestant)
    data = data_options(contestant, kind, size=size, queue=_QUEUE)
    with (
        Program(contestant, "sink", env, **data) as sink,
        Program(contestant, "flood", env, seconds=SECONDS, rate=rate, **data) as flood,
    ):
        flood.read()
        cpu = sink.ask(until=1)["cpu"]
        sent = flood.ask()
        got = sink.ask(until=sent["sent"])
    publisher, subscriber = sent["cpu"], got["cpu"] - cpu
    return {
        "publisher": publisher / sent["seconds"] * 100,
        "subscriber": subscriber / sent["seconds"] * 100,
        "sum": (publisher + subscriber) / sent["seconds"] * 100,
        "rate": got["rate"],
    }


def rows() -> list[Row]:
    return [Row(f"CPU at {label}", partial(steady, rate=rate)) for rate, label in RATES.items()]


def table(report: Report, rounds: int) -> None:
    report.head(
        "What polling costs: messages of 64 B at a rate (CPU % of a core)",
        *("rate", "contestant", "publisher", "subscriber", "sum", "sum / cheapest raw"),
    )
    for row in rows():
        cells = measured(row, [*RAW_WAYS, ZBOT, ASLEEP], rounds)
        raw = cells.median(cells.best(RAW_WAYS, "sum"), "sum")
        for name in cells.names():
            values = [cells.median(name, metric) for metric in ("publisher", "subscriber", "sum")]
            report.row(
                row.label.rpartition(" at ")[2],
                name,
                *(f"{value:.1f}" for value in values),
                f"{values[2] / raw:.2f}",
            )
