"""Many nodes on one machine: their memory, idle CPU time, and how long listing them takes.

Each node is a process with a publisher and a subscription. Only on Linux, which tells a process's
memory and CPU time in files.
"""

from __future__ import annotations

import math
import statistics
import subprocess
import sys
import time
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks.contestant import PROGRAMS, ZBOT, Contestant, Program, environment
from benchmarks.interleaving import Row, Sample, quiet_run
from zbot.transport import router_process

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from benchmarks.report import Report

CROWDS = (1, 10, 60)
FULL_CROWDS = (*CROWDS, 200)
_AT_ONCE = 6  # nodes that start together
_LISTS = 5
_SETTLE_S = 3.0  # a new node looks for missing links for two seconds
_IDLE_S = 5.0
_END_S = 10.0
_CPU_CLOCK = 2  # Linux: CPUCLOCK_SCHED, the CPU time of a process in nanoseconds


def crowd(contestant: Contestant, count: int) -> Sample:
    """Start a number of nodes and measure them."""
    env = environment(contestant)
    with ExitStack() as stack:
        with Program(contestant, "observer", env) as observer:
            observer.ask(until=0)
            nodes: list[Program] = []
            for number in range(count):
                if number >= _AT_ONCE:
                    nodes[number - _AT_ONCE].read()
                program = Program(contestant, "idle", env, node=f"idle_{number}")
                nodes.append(stack.enter_context(program))
            started = time.time()
            listed = observer.ask(until=count)["at"] - started
        pids = [node.pid for node in nodes]
        return {"listed after s": listed, **_lists(env, count), **_idle(env, pids)}


def _lists(env: Mapping[str, str], count: int) -> Sample:
    _wait_for_end_of_observer(env, count)
    found = [_list(env, "node", "list") for _ in range(_LISTS)]
    return {
        "node list ms": statistics.median(took for took, _ in found),
        "topic list ms": statistics.median(_list(env, "topic", "list")[0] for _ in range(_LISTS)),
        "complete lists": sum(len(text.split()) == count for _, text in found) / _LISTS,
    }


def _wait_for_end_of_observer(env: Mapping[str, str], count: int) -> None:
    deadline = time.monotonic() + _END_S
    words = ("node", "list", "--count-nodes")
    while int(_list(env, *words)[1]) > count and time.monotonic() < deadline:
        pass  # a list takes 0.2 s


def _list(env: Mapping[str, str], *words: str) -> tuple[float, str]:
    begun = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", "zbot_cli", *words],
        cwd=PROGRAMS,
        env=dict(env),
        capture_output=True,
        text=True,
        check=True,
    )
    return (time.perf_counter() - begun) * 1000, done.stdout


def _idle(env: Mapping[str, str], pids: list[int]) -> Sample:
    time.sleep(_SETTLE_S)
    router = router_process.pid(int(env["ZBOT_DOMAIN_ID"]))
    everyone = [*pids, *([] if router is None else [router])]
    begun, before = time.perf_counter(), _cpu_s(everyone)
    time.sleep(_IDLE_S)
    used = (_cpu_s(everyone) - before) / (time.perf_counter() - begun)
    return {
        "RSS MB": statistics.median(_memory_mb(pid, "Rss") for pid in pids),
        "PSS MB": statistics.median(_memory_mb(pid, "Pss") for pid in pids),
        "idle CPU %": used * 100,
    }


def _cpu_s(pids: Iterable[int]) -> float:
    if sys.platform != "linux":
        return math.nan
    return sum(time.clock_gettime(~pid << 3 | _CPU_CLOCK) for pid in pids)


def _memory_mb(pid: int, field: str) -> float:
    text = Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="ascii")
    return int(text.split(f"\n{field}:")[1].split()[0]) / 1024


def rows(crowds: Iterable[int]) -> list[Row]:
    return [Row(f"{count} nodes", partial(crowd, count=count)) for count in crowds]


def table(report: Report, crowds: Iterable[int]) -> None:
    report.head(
        "Nodes on one machine",
        "nodes",
        "listed after the last start, s",
        "`zbot node list` ms",
        "complete",
        "`zbot topic list` ms",
        "RSS MB a node",
        "PSS MB a node",
        "idle CPU % in all, with router",
    )
    for row in rows(crowds):
        found = quiet_run(row, ZBOT)
        report.row(
            row.label.split()[0],
            f"{found['listed after s']:.2f}",
            f"{found['node list ms']:.0f}",
            "yes" if found["complete lists"] == 1 else "no",
            f"{found['topic list ms']:.0f}",
            f"{found['RSS MB']:.0f}",
            f"{found['PSS MB']:.0f}",
            f"{found['idle CPU %']:.1f}",
        )
