"""Soak: `python -m tests.torture.soak --minutes 100`.

A domain with nodes of all kinds works for a long time: a ring with keep-all, ten nodes at 100 Hz, a
service with its client, an action server with its client, an open live page under load, and
commands that come and go. Each minute one line of figures is printed: memory, descriptors, threads,
processor time, losses. At the end nothing may have grown and nothing may have been lost.
"""

from __future__ import annotations

import argparse
import http.cookiejar
import re
import secrets
import signal
import sys
import tempfile
import time
import urllib.request
from pathlib import Path
from typing import TYPE_CHECKING

from tests.conftest import wait_until
from tests.torture.page_visit import PageVisit
from tests.torture.processes import Process, Processes, clean_end
from tests.torture.report import Report, times
from tests.torture.stall import StallMeter
from zbot.testing.domain import reserved_domain

if TYPE_CHECKING:
    from collections.abc import Iterator

_TALKERS = 10
_READY_S = 30.0
_COMMAND_PERIOD_S = 15.0
_COMMAND_S = 1.5
_WARM_UP = 0.2  #: the part of the run whose figures are not compared
_MOST_GROWTH = 0.1  #: of the memory, beside:
_MOST_GROWTH_BYTES = 12 * 2**20
_MOST_NEW_DESCRIPTORS = 10
_COMMANDS = (
    ("zbot", "node", "list"),
    ("zbot", "topic", "list"),
    ("zbot", "topic", "echo", "--once", "/numbers"),
    ("zbot", "service", "call", "/add_two_ints", "example_interfaces/srv/AddTwoInts", "{a: 1}"),
    ("zbot", "param", "list"),
)


class Soak:
    """A domain under load."""

    def __init__(self, processes: Processes, report: Report, stall: StallMeter) -> None:
        self._processes, self._report, self._stall = processes, report, stall
        self._usage: dict[Process, list[tuple[int, int, int]]] = {}
        self._commands_s: list[float] = []
        self._pages_s: list[float] = []
        self._nodes = list(self._start_nodes())
        self._page = self._start_page()
        self._lasting = [*self._nodes, self._page]
        self._visit = PageVisit.open(self._address, report)

    def _start_nodes(self) -> Iterator[Process]:
        start = self._processes.start
        for number in range(_TALKERS):
            yield start(f"talker{number}", "holder_talker.py", str(number))
        self._listener = start("listener", "holder_listener.py")
        yield self._listener
        yield start("ring0", "ring_node.py", "ring0", "0", "1", "50")
        yield start("ring1", "ring_node.py", "ring1", "1", "0", "50")
        yield start("service", "zbot", "run", "add_two_ints_server")
        yield start("action", "zbot", "run", "fibonacci_action_server")
        yield start("client", "soak_client.py")
        yield start("logger", "soak_logger.py")

    def _start_page(self) -> Process:
        page = self._processes.start("page", "zbot", "web", "--no-browser", "--port", "0")
        found: list[str] = []

        def is_there() -> bool:
            found[:] = re.findall(r"zbot web: (\S+)", page.text())
            return bool(found)

        if not wait_until(is_there, _READY_S):
            self._report.violation(f"the page did not start: {page.output}")
        self._address = found[0].rstrip("/") if found else ""
        return page

    def run(self, seconds: float) -> None:
        """Let the domain work, and note the figures."""
        begin = time.monotonic()
        pause_s = min(60.0, seconds / 20)
        next_figures, next_command, number = begin + pause_s, begin, 0
        while (now := time.monotonic()) < begin + seconds:
            if now >= next_command:
                next_command = now + _COMMAND_PERIOD_S
                self._run_command(_COMMANDS[number % len(_COMMANDS)])
                self._load_page()
                number += 1
            if now >= next_figures:
                next_figures = now + pause_s
                self._note_figures()
            self._check_running()
            time.sleep(0.2)

    def _run_command(self, words: tuple[str, ...]) -> None:
        begin = time.monotonic()
        process = self._processes.start("command", *words)
        code = process.wait(20)
        took_s = time.monotonic() - begin
        self._commands_s.append(took_s)
        if code != 0 or took_s > self._stall.allowed(_COMMAND_S, begin):
            text = f"`{' '.join(words)}` ended with {code} after {took_s:.2f} s: {process.output}"
            self._report.violation(text)

    def _load_page(self) -> None:
        begin = time.monotonic()
        opener = urllib.request.build_opener(
            urllib.request.HTTPCookieProcessor(http.cookiejar.CookieJar())
        )
        try:
            with opener.open(self._address + "/", timeout=10) as answer:
                answer.read()
        except OSError as error:
            self._report.violation(f"the page does not answer: {error}")
        self._pages_s.append(time.monotonic() - begin)

    def _note_figures(self) -> None:
        total = [0, 0, 0]
        for process in self._lasting:
            used = (*process.usage(), process.threads())
            self._usage.setdefault(process, []).append(used)
            total = [count + more for count, more in zip(total, used, strict=True)]
        page = self._usage[self._page][-1]
        browser = self._visit.memory() if self._visit else 0
        self._report.note(
            f"{len(self._lasting)} processes: {total[0] / 2**20:.0f} MB, {total[1]} descriptors, "
            f"{total[2]} threads; page: {page[0] / 2**20:.0f} MB; browser's scripts: "
            f"{browser / 2**20:.1f} MB; slowdown {self._stall.mean_slowdown():.2f}"
        )

    def _check_running(self) -> None:
        for process in self._lasting[:]:
            if process.exit_code is not None:
                self._lasting.remove(process)
                self._report.violation(
                    f"{process.name} ended with {process.exit_code}: {process.output}"
                )

    def end(self) -> None:
        """End everything, and check that nothing has grown and nothing was lost."""
        if self._visit:
            self._visit.close()
        for process, used in self._usage.items():
            self._check_growth(process, used[int(_WARM_UP * len(used)) :])
        # The clients end before their servers.
        for process in reversed(self._lasting):
            begin = time.monotonic()
            process.signal(signal.SIGINT)
            code = process.wait(10)
            took_s = time.monotonic() - begin
            if code not in {0, 130, -signal.SIGINT} or took_s > self._stall.allowed(1.0, begin):
                self._report.violation(f"{process.name} ended with {code} after {took_s:.2f} s")
        for process in self._processes.all:
            for gap in process.facts("gap"):
                self._report.violation(f"{process.name} missed messages: {gap}")
            for facts in process.facts("failed"):
                self._report.violation(f"{process.name}: {facts}")
            for facts in process.facts("end"):
                self._report.note(f"{process.name}: {facts}")
        for fault in self._processes.faults():
            self._report.violation(fault)
        self._report.note(f"commands: {times(self._commands_s)}")
        self._report.note(f"first page: {times(self._pages_s)}")

    def _check_growth(self, process: Process, used: list[tuple[int, int, int]]) -> None:
        if len(used) < 4:
            return
        part = max(1, len(used) // 4)
        for what, column, most in (
            ("bytes", 0, _MOST_GROWTH_BYTES + _MOST_GROWTH * used[0][0]),
            ("descriptors", 1, _MOST_NEW_DESCRIPTORS),
            ("threads", 2, _MOST_NEW_DESCRIPTORS),
        ):
            first = max(usage[column] for usage in used[:part])
            last = min(usage[column] for usage in used[-part:])
            if last - first > most:
                text = f"{process.name} has {last} {what}, and had {first} after the start"
                self._report.violation(text)


def main() -> int:
    parser = argparse.ArgumentParser(description="Let a domain work for a long time.")
    parser.add_argument("--minutes", type=float, default=100)
    given = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix=f"zbot-soak-{secrets.token_hex(2)}-"))
    report = Report()
    with (
        clean_end(),
        reserved_domain() as domain,
        StallMeter() as stall,
        Processes(folder, domain) as processes,
    ):
        soak = Soak(processes, report, stall)
        with report.until_interrupted():
            soak.run(60 * given.minutes)
        soak.end()
    return report.end(f"python -m tests.torture.soak --minutes {given.minutes:g}", folder, stall)


if __name__ == "__main__":
    sys.exit(main())
