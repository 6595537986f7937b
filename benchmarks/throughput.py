"""One-way messages of twelve types and of growing arrays: rate, losses, CPU time."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from benchmarks.contestant import (
    RAW_WAYS,
    RCLPY,
    ZBOT,
    Contestant,
    Program,
    data_options,
    environment,
)
from benchmarks.interleaving import Cells, Row, Sample, measured

if TYPE_CHECKING:
    from benchmarks.report import Report

SIZES = {
    64: "64 B",
    1024: "1 KiB",
    16384: "16 KiB",
    262_144: "256 KiB",
    1_000_000: "1 MB",
    4_000_000: "4 MB",
}
SECONDS = 0.6
_HEADER_BYTES = 40  # about what zbot's encoding adds to the bytes of an array
_ARRAY_QUEUE = 256  # zbot/node/subscription.py


def one_way(contestant: Contestant, kind: str | int, size: int, queue: int) -> Sample:
    """Return the rate, the losses and the CPU microseconds of a message in both processes."""
    env = environment(contestant)
    data = data_options(contestant, kind, size=size, queue=queue)
    with (
        Program(contestant, "sink", env, **data) as sink,
        Program(contestant, "flood", env, seconds=SECONDS, **data) as flood,
    ):
        flood.read()
        cpu = sink.ask(until=1)["cpu"]
        sent = flood.ask()
        got = sink.ask(until=sent["sent"])
    used = sent["cpu"] + got["cpu"] - cpu
    return {"rate": got["rate"], "lost": got["lost"], "cpu": used / sent["sent"] * 1e6}


def type_facts() -> dict[str, dict[str, int]]:
    with Program(ZBOT, "facts", environment(ZBOT)) as program:
        return program.read()


def type_rows() -> list[Row]:
    return [
        Row(kind, partial(one_way, kind=kind, size=facts["bytes"], queue=facts["queue"]))
        for kind, facts in type_facts().items()
    ]


def size_rows() -> list[Row]:
    return [
        Row(
            f"array of {label}",
            partial(one_way, kind=size, size=size + _HEADER_BYTES, queue=_ARRAY_QUEUE),
        )
        for size, label in SIZES.items()
    ]


def _measured(row: Row, rounds: int) -> tuple[Cells, Contestant]:
    """Return the samples, and raw Zenoh's fastest way to receive."""
    cells = measured(row, [*RAW_WAYS, ZBOT], rounds)
    best = cells.best(RAW_WAYS, "rate", highest=True)
    # The rates vary more than other values, so those that are compared get more rounds.
    cells.measure(row, [best, ZBOT], rounds - 1)
    return cells, cells.best(RAW_WAYS, "rate", highest=True)


def _line(label: str, cells: Cells, raw: Contestant, contestant: Contestant) -> tuple[object, ...]:
    rate, cpu = (cells.median(contestant, metric) for metric in ("rate", "cpu"))
    lost = "most" if contestant in RCLPY else f"{cells.total(contestant, 'lost'):.0f}"
    ratio = rate / cells.median(raw, "rate")
    return label, contestant.name, f"{rate:,.0f}", lost, f"{ratio:.2f}", f"{cpu:.1f}"


def types_table(report: Report, rounds: int) -> None:
    report.head(
        "One way, twelve types, reliable keep-all",
        "type",
        "bytes",
        "raw msg/s (fastest way)",
        "zbot msg/s",
        "lost",
        "zbot / raw",
        "CPU us a message, raw",
        "zbot",
    )
    facts = type_facts()
    for row in type_rows():
        cells, raw = _measured(row, rounds)
        rates = [cells.median(contestant, "rate") for contestant in (raw, ZBOT)]
        report.row(
            row.label,
            f"{facts[row.label]['bytes']:,}",
            f"{rates[0]:,.0f} ({raw.options['way']})",
            f"{rates[1]:,.0f}",
            f"{cells.total(raw, 'lost') + cells.total(ZBOT, 'lost'):.0f}",
            f"{rates[1] / rates[0]:.2f}",
            *(f"{cells.median(contestant, 'cpu'):.1f}" for contestant in (raw, ZBOT)),
        )


def sizes_table(report: Report, rounds: int) -> dict[str, list[tuple[float, float]]]:
    """Print all ways to receive. Return points (bytes, messages per second) of raw and zbot."""
    report.head(
        "One way, arrays of bytes, reliable keep-all",
        "size",
        "contestant",
        "msg/s",
        "lost",
        "rate / raw",
        "CPU us a message",
    )
    points: dict[str, list[tuple[float, float]]] = {"raw Zenoh": [], "zbot": []}
    for size, row in zip(SIZES, size_rows(), strict=True):
        cells, raw = _measured(row, rounds)
        cells.measure(row, RCLPY, min(rounds, 2))
        for contestant in (*RAW_WAYS, ZBOT, *RCLPY):
            report.row(*_line(SIZES[size], cells, raw, contestant))
        points["raw Zenoh"].append((size, cells.median(raw, "rate")))
        points["zbot"].append((size, cells.median(ZBOT, "rate")))
    return points
