"""Faults of the meeting point's router: `python -m tests.torture.meeting_point_holders --runs 50`.

Ten nodes publish at 100 Hz. Then the router of the domain is stopped, stuck, killed or paused, and
at once a new node and `zbot node list` start. Both must work within a second, the new node must
hear all ten nodes, nothing may be lost, and the warning must name the process that was ended.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import re
import secrets
import signal
import sys
import tempfile
import threading
import time
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING

from tests.conftest import wait_until
from tests.torture.freezer import Freezer
from tests.torture.processes import Process, Processes, clean_end
from tests.torture.report import Report, times
from tests.torture.stall import StallMeter
from zbot.testing.domain import reserved_domain

if TYPE_CHECKING:
    from collections.abc import Callable

_NODES = 10
_WORKS_S = 1.0
#: On a busy machine, a router is watched for 3 s before it is called stuck.
_BUSY_STUCK_S = 3.0
_BUSY = 1.3
_HANG_S = 20.0
_READY_S = 20.0
_WARNING = re.compile(r"router of domain \d+ \(process (\d+)\) did not answer")
KINDS = ("none", "stopped", "killed", "paused", "stuck")


class MeetingPointHolders:
    """Ten nodes in a domain, and the faults of its router."""

    def __init__(
        self,
        processes: Processes,
        seed: str,
        report: Report,
        stall: StallMeter,
        freezer: Freezer,
    ) -> None:
        self._freezer = freezer
        self._processes, self._report, self._stall = processes, report, stall
        self._random = Random(seed)
        self._nodes = [
            processes.start(f"talker{number}", "holder_talker.py", str(number))
            for number in range(_NODES)
        ]
        self._listener = processes.start("listener", "holder_listener.py")
        for process in (*self._nodes, self._listener):
            if process.wait_for("ready", _READY_S) is None:
                report.violation(f"{process.name} did not start: {process.output}")

    def _router(self) -> int | None:
        for path in self._processes.settings.glob("zbot/router-*.lock"):
            with contextlib.suppress(OSError, ValueError):
                number = int(path.read_text(encoding="utf-8"))
                if number in self._processes.ids():
                    return number
        return None

    def run(self, kind: str, runs: int) -> None:
        """Run one kind of fault several times."""
        nodes_s, lists_s = list[float](), list[float]()
        for _ in range(runs):
            found: list[int] = []
            wait_until(lambda found=found: self._find(found), _READY_S)  # type: ignore[misc]
            if not found:
                self._report.violation(f"{kind}: there is no router")
                return
            time.sleep(self._random.uniform(0.2, 0.6))  # the router has all links again
            router = self._router() or found[0]
            undo: Callable[[], object] = getattr(self, f"_{kind}")(router)
            begin = time.monotonic()
            node = self._processes.start("new", "holder_new.py", str(_NODES))
            listing = self._processes.start("list", "zbot", "node", "list")
            ends = self._wait(node, listing)
            undo()
            self._check(kind, router, begin, node, listing, ends)
            nodes_s.append(ends[0])
            lists_s.append(ends[1])
        self._report.note(f"{kind}: new node: {times(nodes_s)}")
        self._report.note(f"{kind}: `zbot node list`: {times(lists_s)}")

    def _find(self, found: list[int]) -> bool:
        router = self._router()
        if router is not None:
            found.append(router)
        return router is not None

    @staticmethod
    def _wait(*some: Process) -> list[float]:
        """Return how long each process needed to its end."""
        took_s = [0.0] * len(some)

        def wait(index: int) -> None:
            some[index].wait(_HANG_S)
            took_s[index] = time.monotonic() - some[index].started

        threads = [threading.Thread(target=wait, args=(index,)) for index in range(len(some))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return took_s

    def _check(
        self,
        kind: str,
        router: int,
        begin: float,
        node: Process,
        listing: Process,
        ends: list[float],
    ) -> None:
        limit_s = self._stall.allowed(_WORKS_S, begin)
        if kind == "stuck" and self._stall.allowed(1.0, begin) > _BUSY:
            limit_s += _BUSY_STUCK_S
        for process, took_s in zip((node, listing), ends, strict=True):
            if process.exit_code != 0 or took_s > limit_s:
                text = f"{process.name} ended with {process.exit_code} after {took_s:.2f} s"
                self._report.violation(f"{kind}: {text}: {process.output}")
        heard = [facts["count"] for facts in node.facts("heard")]
        if heard != [_NODES]:
            self._report.violation(f"{kind}: the new node heard {heard} nodes: {node.output}")
        listed = len(re.findall(r"^/talker", listing.text(), re.MULTILINE))
        if listed != _NODES:
            self._report.violation(f"{kind}: {listed} nodes were listed: {listing.output}")
        named = {
            int(number)
            for program in (node, listing)
            for number in _WARNING.findall(program.text())
        }
        if named - {router}:
            self._report.violation(f"{kind}: {named} were named, and the router was {router}")
        if kind in {"stopped", "stuck"} and not named and not self._is_named(router):
            self._report.violation(f"{kind}: no warning names the process {router}")

    def _is_named(self, router: int) -> bool:
        """Return whether a node that was there before has replaced the router, and said so."""
        running = (*self._nodes, self._listener)
        return any(f"(process {router}) did not answer" in program.text() for program in running)

    # -- faults: each returns a function that undoes it ------------------------------------------

    @staticmethod
    def _none(_: int) -> Callable[[], object]:
        return lambda: None

    @staticmethod
    def _stopped(router: int) -> Callable[[], object]:
        os.kill(router, signal.SIGSTOP)
        return lambda: None

    @staticmethod
    def _killed(router: int) -> Callable[[], object]:
        os.kill(router, signal.SIGKILL)
        return lambda: None

    def _paused(self, router: int) -> Callable[[], object]:
        os.kill(router, signal.SIGSTOP)

        def go_on() -> None:
            if router in self._processes.ids():
                os.kill(router, signal.SIGCONT)

        timer = threading.Timer(self._random.uniform(0.05, 0.5), go_on)
        timer.start()
        return timer.join

    def _stuck(self, router: int) -> Callable[[], object]:
        self._freezer.freeze(router)
        return lambda: None

    # -- the end ---------------------------------------------------------------------------------

    def end(self) -> None:
        """End the nodes, and check that no message was lost."""
        for process in (*self._nodes, self._listener):
            process.signal(signal.SIGINT)
            begin = time.monotonic()
            code = process.wait(10)
            took_s = time.monotonic() - begin
            if code != 0 or took_s > self._stall.allowed(1.0, begin):
                self._report.violation(f"{process.name} ended with {code} after {took_s:.2f} s")
        for gap in self._listener.facts("gap"):
            self._report.violation(f"the listener missed messages: {gap}")
        for facts in self._listener.facts("end"):
            self._report.note(f"{facts['received']} messages received, {facts['gaps']} gaps")
        for fault in self._processes.faults():
            self._report.violation(fault)


def main() -> int:
    parser = argparse.ArgumentParser(description="Faults of the router of a domain.")
    parser.add_argument("--runs", type=int, default=50, help="runs of each kind")
    parser.add_argument("--seed", default="", help="text")
    parser.add_argument("--kind", action="append", choices=KINDS, help="only this kind")
    given = parser.parse_args()
    seed = given.seed or secrets.token_hex(4)
    kinds = given.kind or KINDS
    print(f"seed {seed}, {given.runs} runs of each of {', '.join(kinds)}", flush=True)
    folder = Path(tempfile.mkdtemp(prefix="zbot-holders-"))
    report = Report()
    with (
        clean_end(),
        reserved_domain() as domain,
        StallMeter() as stall,
        Freezer() as freezer,
        Processes(folder, domain) as processes,
    ):
        holders = MeetingPointHolders(processes, seed, report, stall, freezer)
        with report.until_interrupted():
            for kind in kinds:
                if kind == "stuck" and not freezer.works:
                    report.note("stuck: not run, because this machine cannot freeze a process")
                else:
                    holders.run(kind, given.runs)
        holders.end()
    words = "".join(f" --kind {kind}" for kind in given.kind or ())
    again = f"python -m tests.torture.meeting_point_holders --seed {seed} --runs {given.runs}"
    return report.end(again + words, folder, stall)


if __name__ == "__main__":
    sys.exit(main())
