"""Time that whole processes take to start."""

from __future__ import annotations

import subprocess
import sys
import time
from functools import partial
from typing import TYPE_CHECKING

from benchmarks.contestant import PROGRAMS, ZBOT, Contestant, Program, environment
from benchmarks.interleaving import Row, Sample, measured

if TYPE_CHECKING:
    from benchmarks.report import Report


def command(contestant: Contestant, words: tuple[str, ...]) -> Sample:
    """Return the milliseconds of a run of Python with these words."""
    env = environment(contestant)
    begun = time.perf_counter()
    subprocess.run(
        [sys.executable, *words], cwd=PROGRAMS, env=env, check=True, stdout=subprocess.DEVNULL
    )
    return {"ms": (time.perf_counter() - begun) * 1000}


def first_message(contestant: Contestant) -> Sample:
    """Return the milliseconds from a process's start to its first message at a subscriber."""
    env = environment(contestant)
    with Program(contestant, "sink", env, kind=64) as sink:
        sink.ask(until=0)
        begun = time.time()
        with Program(contestant, "flood", env, kind=64, seconds=0) as flood:
            flood.read()
            return {"ms": (sink.ask(until=1)["arrival"] - begun) * 1000}


def rows() -> list[Row]:
    run = {"bare python": ("-c", ""), "`zbot --help`": ("-m", "zbot_cli", "--help")}
    return [
        *(Row(label, partial(command, words=words)) for label, words in run.items()),
        Row("process start to first message at a subscriber", first_message),
    ]


def table(report: Report, rounds: int) -> None:
    report.head("Start (milliseconds, whole processes)", "what", "median")
    for row in rows():
        report.row(row.label, f"{measured(row, [ZBOT], rounds).median(ZBOT, 'ms'):.0f}")
