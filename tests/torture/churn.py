"""Churn: `python -m tests.torture.churn --runs 24000 --starts 200000`.

Entities of each kind are created and destroyed many times. A program that watches the graph runs
beside. Neither of both programs may need more memory at the end, and the last cycles may not take
longer than the first.

Then contexts with nodes come and go, at a domain's router that is linked to a hub, which is linked
to another hub. At the end, the router and the far hub must answer as fast as at the beginning. How
long a context takes to start is told, but not judged (docs/design/zenoh-faults.md).
"""

from __future__ import annotations

import argparse
import json
import secrets
import socket
import statistics
import sys
import tempfile
import time
from pathlib import Path

import zenoh

from tests.conftest import wait_until
from tests.torture.processes import Process, Processes, clean_end
from tests.torture.report import Report
from tests.torture.stall import StallMeter
from zbot.testing.domain import reserved_domain

KINDS = (
    *("publisher", "latched publisher", "subscription", "latched subscription"),
    *("service", "client", "timer", "guard condition"),
    *("action server", "action client", "node", "logging node"),
)
_BLOCKS = 12
_WARM_BLOCKS = 3  #: the memory and the time after these blocks are compared with those at the end
_MOST_GROWTH = 5 * 2**20
_MOST_SLOWER = 2.0  #: times
_LEAST_US = 100.0  #: shorter cycles are not compared
_CYCLE_S = 0.05  #: a cycle takes less time
_READY_S = 30.0
_CONTEXTS = 100  #: of one process, because Zenoh leaves a descriptor for each session
_ENTITIES = 12  #: tokens of a node of `churn_contexts.py`
_ANSWERS = 5
_MOST_LATER_S = 0.1  #: an answer may take this much longer at the end


class Churn:
    """A domain in which entities come and go."""

    def __init__(self, processes: Processes, report: Report, stall: StallMeter) -> None:
        self._processes, self._report, self._stall = processes, report, stall

    def create_entities(self, kind: str, runs: int) -> None:
        """Create and destroy entities of a kind."""
        watcher = self._started("watcher", "churn_watcher.py")
        before = 0
        words = (kind, str(runs), str(_BLOCKS))
        churn = self._processes.start(kind, "churn_entities.py", *words)
        limit_s = _READY_S + runs * _CYCLE_S
        wait_until(
            lambda: len(churn.facts("block")) >= _WARM_BLOCKS or churn.exit_code is not None,
            limit_s,
        )
        before = watcher.usage()[0]
        ended = churn.wait_for("end", limit_s)
        blocks = churn.facts("block")
        if ended is None:
            self._report.violation(f"{kind}: no end after {len(blocks)} blocks: {churn.output}")
        else:
            self._compare(kind, blocks, watcher.usage()[0] - before)
        for process in (churn, watcher):
            process.signal(2)
            process.wait(10)
        self._report.count("kinds")

    def _compare(self, kind: str, blocks: list[dict[str, float]], watched: float) -> None:
        warm = blocks[_WARM_BLOCKS - 1]
        first_us = statistics.median(block["each_us"] for block in blocks[:_WARM_BLOCKS])
        last_us = statistics.median(block["each_us"] for block in blocks[-_WARM_BLOCKS:])
        grown = blocks[-1]["bytes"] - warm["bytes"]
        self._report.note(
            f"{kind}: {first_us:.0f} us a cycle, then {last_us:.0f} us; "
            f"{grown / 2**20:+.1f} MB, watcher {watched / 2**20:+.1f} MB"
        )
        if max(grown, watched) > _MOST_GROWTH:
            self._report.violation(f"{kind}: the memory has grown by {max(grown, watched):.0f}")
        if last_us > max(_LEAST_US, first_us) * _MOST_SLOWER * self._stall.mean_slowdown():
            self._report.violation(f"{kind}: a cycle takes {last_us:.0f} us, not {first_us:.0f}")

    def _started(self, name: str, *words: str, **more: str) -> Process:
        process = self._processes.start(name, *words, **more)
        if process.wait_for("ready", _READY_S) is None:
            self._report.violation(f"{name} did not start: {process.output}")
        return process


class HubChurn(Churn):
    """A domain in which programs come and go. Its router is linked to two hubs in a row."""

    def __init__(self, processes: Processes, report: Report, stall: StallMeter) -> None:
        super().__init__(processes, report, stall)
        self._near, self._far = _free_port(), _free_port()
        self._start_hub("near", self._near)
        self._start_hub("far", self._far, "--connect", f"127.0.0.1:{self._near}")
        self._watcher = self._started("watcher", "churn_watcher.py", **self._variables())
        self._far_session = _client_of(self._far)

    def _variables(self) -> dict[str, str]:
        return {"ZBOT_HUB_PORT": str(self._near)}

    def _start_hub(self, name: str, port: int, *words: str) -> None:
        home = self._processes.folder / name
        home.mkdir()
        more = {"XDG_CONFIG_HOME": str(home), "ZBOT_HUB_PORT": str(port)}
        hub = self._processes.start(
            name, "zbot", "hub", "--listen", f"127.0.0.1:{port}", *words, **more
        )
        if not wait_until(lambda: "Ctrl-C ends it" in hub.text(), _READY_S):
            self._report.violation(f"the hub did not start: {hub.output}")

    def run(self, starts: int) -> None:
        """Let nodes come and go until entities were started this many times."""
        if not wait_until(self._sees_watcher, _READY_S):
            self._report.violation("the far hub does not know the node")
        first = self._answers()
        rounds = max(1, starts // (_CONTEXTS * _ENTITIES))
        for number in range(rounds):
            each_s = self._visit()
            if number % max(1, rounds // 20) == 0:
                self._note(number + 1, each_s)
        last = self._answers()
        for what in first:
            self._report.note(
                f"{what}: {first[what]:.3f} s at the begin, {last[what]:.3f} s at the end"
            )
            if last[what] > first[what] * self._stall.mean_slowdown() + _MOST_LATER_S:
                self._report.violation(f"{what} answers after {last[what]:.2f} s")
        self._far_session.close()

    def _visit(self) -> float:
        """Let nodes come and go. Return how long each took, in seconds."""
        visitors = self._processes.start(
            "visitors", "churn_contexts.py", str(_CONTEXTS), **self._variables()
        )
        code = visitors.wait(120)
        if code != 0:
            self._report.violation(f"visitors ended with {code}: {visitors.output}")
        self._report.count("visits")
        each_s: float = sum(end["each_s"] for end in visitors.facts("end"))
        return each_s

    def _note(self, number: int, each_s: float) -> None:
        answers = ", ".join(f"{what} {took_s:.3f} s" for what, took_s in self._answers(1).items())
        memory = ", ".join(
            f"{process.name} {process.usage()[0] / 2**20:.0f} MB"
            for process in self._processes.all
            if process.exit_code is None
        )
        self._report.note(
            f"{number * _CONTEXTS * _ENTITIES} entities: {answers}, start {each_s:.3f} s; {memory}"
        )

    def _answers(self, count: int = _ANSWERS) -> dict[str, float]:
        """Return how long the domain's router and the far hub take to list the nodes (median)."""
        found: dict[str, list[float]] = {"router": [], "far hub": []}
        for _ in range(count):
            begin = time.monotonic()
            command = self._processes.start("list", "zbot", "node", "list", **self._variables())
            if command.wait(20) != 0 or "/watcher" not in command.text():
                self._report.violation(f"the list is wrong: {command.output}")
            found["router"].append(time.monotonic() - begin)
            begin = time.monotonic()
            # While a link is renewed, the list of the far hub is not complete.
            if not wait_until(self._sees_watcher, 2):
                self._report.violation("the far hub does not know the node")
            found["far hub"].append(time.monotonic() - begin)
        return {what: statistics.median(times) for what, times in found.items()}

    def _sees_watcher(self) -> bool:
        key = f"@zbot/{self._processes.domain}/*/*/*/NN/**"
        replies = self._far_session.liveliness().get(
            key, zenoh.handlers.FifoChannel(10_000), timeout=10
        )
        return any(str(reply.ok.key_expr).endswith("/watcher") for reply in replies if reply.ok)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        number: int = probe.getsockname()[1]
        return number


def _client_of(port: int) -> zenoh.Session:
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", json.dumps([f"tcp/127.0.0.1:{port}"]))
    config.insert_json5("scouting/multicast/enabled", "false")
    return zenoh.open(config)


def main() -> int:
    parser = argparse.ArgumentParser(description="Create and destroy entities and programs.")
    parser.add_argument("--runs", type=int, default=24_000, help="cycles of each kind; 0 for none")
    parser.add_argument("--starts", type=int, default=200_000, help="entities of programs")
    parser.add_argument("--kind", choices=KINDS, action="append", help="only these kinds")
    given = parser.parse_args()
    report = Report()
    folder = Path(tempfile.mkdtemp(prefix=f"zbot-churn-{secrets.token_hex(2)}-"))
    with clean_end(), StallMeter() as stall, report.until_interrupted():
        for kind in (given.kind or KINDS) if given.runs else ():
            (own := folder / kind.replace(" ", "-")).mkdir()
            with reserved_domain() as domain, Processes(own, domain) as processes:
                Churn(processes, report, stall).create_entities(kind, given.runs)
        if given.starts:
            (own := folder / "hubs").mkdir()
            with reserved_domain() as domain, Processes(own, domain) as processes:
                HubChurn(processes, report, stall).run(given.starts)
                for fault in processes.faults():
                    report.violation(fault)
    again = f"python -m tests.torture.churn --runs {given.runs} --starts {given.starts}"
    return report.end(again, folder, stall)


if __name__ == "__main__":
    sys.exit(main())
