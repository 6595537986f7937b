"""Comparison of this checkout with another one: each row runs in both, in turns."""

from __future__ import annotations

import platform
import statistics
from dataclasses import replace
from typing import TYPE_CHECKING

from benchmarks import busy_waiting, delays, jitter, nodes, round_trips, start, throughput
from benchmarks.contestant import ZBOT
from benchmarks.interleaving import quiet_run

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from benchmarks.contestant import Contestant
    from benchmarks.interleaving import Row
    from benchmarks.report import Report


def rows(crowds: Iterable[int]) -> list[Row]:
    """Return the rows of all tables."""
    found = [
        *round_trips.rows(),
        round_trips.service_row(),
        *throughput.type_rows(),
        *throughput.size_rows(),
        *delays.rows(),
        *busy_waiting.rows(),
        *jitter.rows(),
        *start.rows(),
    ]
    return [*found, *nodes.rows(crowds)] if platform.system() == "Linux" else found


def compare(report: Report, other: Path, rows: Iterable[Row], rounds: int) -> None:
    """Print this checkout's value, the other's, and the ratio of each pair of runs."""
    contestants = (ZBOT, replace(ZBOT, name="other", checkout=other))
    report.head(
        f"This checkout and {other.name}, medians of {rounds} pairs of runs",
        *("row", "value", "this", "other", "this / other", "smallest and largest ratio"),
    )
    for row in rows:
        pairs = [_pair(row, contestants, turn) for turn in range(rounds)]
        for metric in pairs[0][0]:
            here, there = ([cell[metric] for cell in side] for side in zip(*pairs, strict=True))
            ratios = [a / b for a, b in zip(here, there, strict=True) if b]
            report.row(
                row.label,
                metric,
                *(f"{statistics.median(values):,.4g}" for values in (here, there)),
                f"{statistics.median(ratios):.2f}" if ratios else "",
                f"{min(ratios):.2f} {max(ratios):.2f}" if ratios else "",
            )


def _pair(
    row: Row, contestants: tuple[Contestant, Contestant], turn: int
) -> tuple[dict[str, float], dict[str, float]]:
    """Return this checkout's sample and the other's. The order changes with each turn."""
    here, there = contestants
    if turn % 2:
        second = quiet_run(row, there)
        return quiet_run(row, here), second
    return quiet_run(row, here), quiet_run(row, there)
