"""Messages one way at the rates that robots use, from publish() to another process's callback."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from benchmarks.contestant import (
    ASLEEP,
    PLAIN,
    RAW_WAYS,
    RCLPY,
    ZBOT,
    Contestant,
    Program,
    environment,
)
from benchmarks.interleaving import Row, Sample, measured, percentile

if TYPE_CHECKING:
    from benchmarks.report import Report

#: Messages a second, each with its name and the seconds of a run.
RATES = {
    10: ("10 Hz", 6.0),
    100: ("100 Hz", 3.0),
    1000: ("1 kHz", 2.0),
    5000: ("5 kHz", 2.0),
}


def delay(contestant: Contestant, rate: float, seconds: float) -> Sample:
    """Return percentiles in microseconds, and the CPU percent of both processes together."""
    env = environment(contestant)
    with (
        Program(contestant, "listener", env) as listener,
        Program(contestant, "talker", env, seconds=seconds, rate=rate) as talker,
    ):
        talker.read()
        cpu = listener.ask(until=1)["cpu"]
        sent = talker.ask()
        got = listener.ask(until=sent["sent"])
    shares = {"p50": 0.5, "p90": 0.9, "p99": 0.99}
    times = {name: percentile(got["delays"], share) / 1000 for name, share in shares.items()}
    return {
        **times,
        "publisher": sent["cpu"] / sent["seconds"] * 100,
        "subscriber": (got["cpu"] - cpu) / sent["seconds"] * 100,
        "lost": sent["sent"] - len(got["delays"]),
    }


def rows() -> list[Row]:
    return [
        Row(f"one way at {label}", partial(delay, rate=rate, seconds=seconds))
        for rate, (label, seconds) in RATES.items()
    ]


def table(report: Report, rounds: int) -> None:
    report.head(
        "One way at a rate, Int64, two processes (microseconds; CPU % of a core)",
        *("rate", "contestant", "p50", "p90", "p99", "p50 / raw", "publisher", "subscriber"),
    )
    for row in rows():
        cells = measured(row, [*RAW_WAYS, PLAIN, ZBOT, ASLEEP, *RCLPY], rounds)
        raw = cells.median(cells.best(RAW_WAYS, "p50"), "p50")
        for name in cells.names():
            times = [cells.median(name, metric) for metric in ("p50", "p90", "p99")]
            report.row(
                row.label.rpartition(" at ")[2],
                name,
                *(f"{time:.0f}" for time in times),
                f"{times[0] / raw:.2f}",
                *(f"{cells.median(name, metric):.1f}" for metric in ("publisher", "subscriber")),
            )
