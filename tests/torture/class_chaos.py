"""Faults in a class: laptops in network namespaces, their hubs, and the teacher's hub."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import time
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING

from tests.classroom.impairment import Impairment, impair
from tests.classroom.lesson import hub_pid
from tests.classroom.testbed import LanTestbed, missing_requirement
from tests.torture.faults import Fault, Schedule, plan
from tests.torture.report import times
from zbot.transport.config import DROP_WAIT_US

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from tests.classroom.machine import Finished, Machine
    from tests.conftest import Program
    from tests.torture.report import Report
    from tests.torture.stall import StallMeter

_LAPTOPS, _NODES, _HZ = 4, 3, 5
_PAUSE_S = 4.0
_TRUE_LIST_S = 3.0
#: Hubs notice a cut after at most this time (docs/wire.md), and then lists become true.
_CUT_S = 4.0
#: Zenoh closes a link without messages after 10 s. On a link without data, the last message may be
#: 2.5 s old when a laptop begins to sleep. After a longer sleep, nodes of the laptop lose links.
_SLEEP_S = 7.0
_WOKEN_S = 3.0
#: A lost message is noticed with the next message, which comes within this time.
_GAP_S = 2.0
#: A new watcher gets all tokens of a hub within this time.
_WATCHED_S = 2.0
_COMMAND_PERIOD_S = 9.0
#: The list waits 2 s for a laptop whose link was cut just before: TCP repeats packets late.
_COMMAND_S = 2.5
_CALM_S = 15.0
_LOG_LINES = 20  #: of a hub, shown when the class does not see a node
_PIN = "4711"
_CRASHES = ("Traceback (most recent call last)", "panicked at", "Fatal Python error")
_KINDS = {
    "kill": 4.0,
    "cut": 3.0,
    "unplug": 2.0,
    "sleep": 2.0,
    "hub killed": 1.5,
    "teacher killed": 1.5,
    "teacher stopped": 1.5,
}


@dataclass(eq=False)
class _Laptop:
    """A laptop and its nodes."""

    machine: Machine
    number: int
    nodes: dict[str, Program] = field(default_factory=dict)
    since: float = 0.0
    is_faulty: bool = False
    is_reported: bool = False
    broken_until: float = 0.0  #: until then, its nodes may lose messages

    def change(self) -> None:
        """Note that its state has changed now."""
        self.since, self.is_reported = time.monotonic(), False


class ClassChaos:
    """Chaos in a class.

    Args:
        testbed: The machines.
        seed: Text.
        seconds: How long faults occur.
        report: Takes what breaks a promise.
        stall: Extends the limits of time on a busy machine.
    """

    def __init__(
        self, testbed: LanTestbed, seed: str, seconds: float, report: Report, stall: StallMeter
    ) -> None:
        self._testbed, self._report, self._stall = testbed, report, stall
        self._seconds = seconds
        self._plan = plan(f"{seed}/class", _KINDS, seconds, _PAUSE_S)
        self._later = Schedule()
        self._seen: set[tuple[int, str]] = set()
        self._programs: list[tuple[_Laptop, str, Program]] = []
        self._teacher_since = 0.0
        self._teacher_is_faulty = False
        self._listed_s: list[float] = []
        self._code = self._open_class()
        self._laptops = [
            _Laptop(machine, number) for number, machine in enumerate(testbed.laptops, 1)
        ]
        tool = impair(testbed, Impairment(loss=0.0), [self._laptops[-1].machine])
        report.note(f"class: the messages of the last laptop are late by {tool}")
        self._watch = testbed.teacher.start("watch.py")
        self._watch.wait_for("watching")
        for laptop in self._laptops:
            self._join(laptop)
            for index in range(_NODES):
                self._start_node(laptop, f"pupil{index}")

    # -- the run ---------------------------------------------------------------------------------

    def run(self) -> None:
        """Let the faults of the plan occur, and check the promises meanwhile."""
        begin = time.monotonic()
        for fault in self._plan:
            self._later.add(fault.at_s, partial(self._begin_fault, fault))
        self._later.add(_COMMAND_PERIOD_S, self._list_class)
        while time.monotonic() < begin + self._seconds + _CALM_S:
            self._later.run_due()
            self._check()
            time.sleep(0.1)
        self._end(begin)

    def _begin_fault(self, fault: Fault) -> None:
        self._report.count(f"class {fault.kind}")
        act: Callable[[Fault], str] = getattr(self, f"_fault_{fault.kind.replace(' ', '_')}")
        self._report.note(f"class: {fault.kind} {act(fault)}")

    def _end(self, begin: float) -> None:
        for laptop in self._laptops:
            for program in laptop.nodes.values():
                program.process.send_signal(signal.SIGINT)
                self._check_end(program)
        self._read_programs()
        note = self._report.note
        note(f"class: {len(self._plan)} faults in {time.monotonic() - begin:.0f} s")
        note(f"class: `zbot class list`: {times(self._listed_s)}")

    def _read_programs(self) -> None:
        """Report what the nodes have printed since the last call."""
        for laptop, name, program in self._programs:
            for line in program.new_lines():
                if any(crash in line for crash in _CRASHES):
                    self._report.violation(f"{name} printed: {line}")
                words = line.split()
                # A neighbour that was started again begins with 1.
                if words[:1] == ["gap"] and int(words[2]) > int(words[1]):
                    self._note_gap(laptop, f"{name} missed messages of its neighbour: {line}")

    def _note_gap(self, laptop: _Laptop, text: str) -> None:
        """Report lost messages, unless the laptop or the machine explains them."""
        # A publisher drops a message if no thread sends the earlier ones for `DROP_WAIT_US`.
        waited_s = self._stall.allowed(0.0, time.monotonic() - _GAP_S)
        if time.monotonic() < laptop.broken_until:
            why = "after a long sleep"
        elif waited_s > DROP_WAIT_US / 1e6:
            why = "on a busy machine"
        else:
            self._report.violation(text)
            return
        self._report.count(f"class gap {why}")
        self._report.note(f"class: {why}, {text}")

    def _check_end(self, program: Program) -> None:
        begin = time.monotonic()
        with contextlib.suppress(Exception):
            program.wait(10)
        took_s = time.monotonic() - begin
        if program.process.poll() != 0 or took_s > self._stall.allowed(1.0, begin):
            code = program.process.poll()
            self._report.violation(f"a node of the class ended with {code} after {took_s:.1f} s")

    # -- the class -------------------------------------------------------------------------------

    def _run(self, machine: Machine, *words: str) -> Finished | None:
        begin = time.monotonic()
        try:
            done = machine.run("zbot", *words, env={"ZBOT_PIN": _PIN}, timeout_s=60)
        except Exception as error:  # noqa: BLE001 - a command that hangs is what we look for
            self._report.violation(f"{machine.name}: {error}")
            return None
        if done.code or any(crash in done.err for crash in _CRASHES):
            took_s = time.monotonic() - begin
            text = f"{machine.name}: `zbot {' '.join(words)}` ended with {done.code}"
            self._report.violation(f"{text} after {took_s:.1f} s: {done.err.strip()[-300:]}")
        return done

    def _open_class(self) -> str:
        done = self._run(self._testbed.teacher, "class", "start", "Robots", "--json", "--pin")
        self._teacher_is_faulty = False
        self._teacher_since = time.monotonic()
        return str(json.loads(done.out)["code"]) if done is not None and not done.code else ""

    def _join(self, laptop: _Laptop) -> None:
        self._run(laptop.machine, "join", self._code, "--number", str(laptop.number))
        laptop.is_faulty = False
        laptop.change()

    def _start_node(self, laptop: _Laptop, name: str) -> None:
        neighbour = f"pupil{(int(name[-1]) + 1) % _NODES}"
        words = ("pupil.py", name, neighbour, "--hz", str(_HZ))
        laptop.nodes[name] = laptop.machine.start(*words)
        named = f"{name} of laptop {laptop.number}"
        self._programs.append((laptop, named, laptop.nodes[name]))
        laptop.change()

    def _list_class(self) -> None:
        self._later.add(_COMMAND_PERIOD_S, self._list_class)
        if self._teacher_is_faulty or any(laptop.is_faulty for laptop in self._laptops):
            return
        begin = time.monotonic()
        done = self._run(self._testbed.teacher, "class", "list", "--json")
        if done is not None:
            self._listed_s.append(done.took_s)
            if done.took_s > self._stall.allowed(_COMMAND_S, begin):
                self._report.violation(f"`zbot class list` needed {done.took_s:.1f} s")

    def _check(self) -> None:
        """Compare the nodes that the teacher's hub sees with those that run."""
        self._read_programs()
        for line in self._watch.new_lines():
            kind, _, domain, node = line.split()
            change = self._seen.add if kind == "up" else self._seen.discard
            change((int(domain), node))
        if self._teacher_is_faulty:
            return
        for laptop in self._laptops:
            since = max(laptop.since, self._teacher_since)
            wanted = {f"/{name}" for name in laptop.nodes}
            seen = {node for domain, node in self._seen if domain == laptop.number}
            waited_s = time.monotonic() - since
            if laptop.is_reported and seen == wanted:
                laptop.is_reported = False
                self._report.note(f"class: laptop {laptop.number} is right after {waited_s:.1f} s")
            if laptop.is_faulty or seen == wanted:
                continue
            limit_s = self._stall.allowed(_TRUE_LIST_S + _CUT_S, since)
            if waited_s > limit_s and not laptop.is_reported:
                laptop.is_reported = True
                self._report.violation(
                    f"after {waited_s:.1f} s the teacher sees {sorted(seen)} and not "
                    f"{sorted(wanted)} of laptop {laptop.number}"
                )
                self._compare_hubs(laptop)

    def _compare_hubs(self, laptop: _Laptop) -> None:
        """Note what new watchers see: so it is known which hub does not know a node."""
        machines = (self._testbed.teacher, laptop.machine)
        for machine in machines:
            for line in machine.run("ss", "-tnp").out.splitlines():
                self._report.note(f"class: socket of {machine.name}: {line}")
        for machine in machines:
            watch = machine.start("watch.py", str(laptop.number))
            watch.wait_for("watching")
            time.sleep(_WATCHED_S)
            seen = sorted(line.split()[3] for line in watch.new_lines() if " " in line)
            watch.process.kill()
            self._report.note(f"class: a new watcher at the hub of {machine.name} sees {seen}")
            for log in machine.home.rglob("hub.log"):
                for line in log.read_text(encoding="utf-8").splitlines()[-_LOG_LINES:]:
                    self._report.note(f"class: hub of {machine.name}: {line}")
        listed = laptop.machine.run("zbot", "node", "list")
        self._report.note(f"class: {laptop.machine.name} lists {listed.out.split()}")

    # -- faults ----------------------------------------------------------------------------------

    def _victim(self, fault: Fault) -> _Laptop | None:
        able = [laptop for laptop in self._laptops if not laptop.is_faulty]
        return able[fault.victim % len(able)] if able else None

    def _fault_kill(self, fault: Fault) -> str:
        laptop = self._victim(fault)
        if laptop is None or not laptop.nodes:
            return "nobody"
        name = sorted(laptop.nodes)[fault.victim % len(laptop.nodes)]
        program = laptop.nodes.pop(name)
        program.process.kill()
        program.process.wait(5)
        laptop.change()
        self._later.add(4 * fault.size, partial(self._start_node, laptop, name))
        return f"{name} of laptop {laptop.number} for {4 * fault.size:.1f} s"

    def _disturb(
        self,
        fault: Fault,
        begin: Callable[[Machine], None],
        end: Callable[[Machine], None],
        longest_s: float = 60.0,
    ) -> str:
        """Disturb a laptop. After more than `longest_s`, its own links may be lost too."""
        laptop = self._victim(fault)
        if laptop is None:
            return "nobody"
        laptop.is_faulty = True
        begin(laptop.machine)

        seconds = 0.5 + 8 * fault.size**2

        def undo() -> None:
            if time.monotonic() - begun > longest_s:
                laptop.broken_until = time.monotonic() + self._stall.allowed(_WOKEN_S, begun)
            end(laptop.machine)
            laptop.is_faulty = False
            laptop.change()

        begun = time.monotonic()
        self._later.add(seconds, undo)
        return f"of laptop {laptop.number} for {seconds:.1f} s"

    def _fault_cut(self, fault: Fault) -> str:
        return self._disturb(
            fault, lambda laptop: laptop.disconnect(), lambda laptop: laptop.reconnect()
        )

    def _fault_unplug(self, fault: Fault) -> str:
        return self._disturb(fault, lambda laptop: laptop.unplug(), lambda laptop: laptop.plug_in())

    def _fault_sleep(self, fault: Fault) -> str:
        return self._disturb(
            fault, lambda laptop: laptop.sleep(), lambda laptop: laptop.wake_up(), _SLEEP_S
        )

    def _fault_hub_killed(self, fault: Fault) -> str:
        """Kill the hub of a laptop. The student joins again later, as `zbot status` says."""
        laptop = self._victim(fault)
        if laptop is None:
            return "nobody"
        laptop.is_faulty = True
        os.kill(hub_pid(laptop.machine), signal.SIGKILL)
        self._later.add(3 * fault.size, partial(self._join_when_open, laptop))
        return f"of laptop {laptop.number} for {3 * fault.size:.1f} s"

    def _join_when_open(self, laptop: _Laptop) -> None:
        if self._teacher_is_faulty:
            self._later.add(1.0, partial(self._join_when_open, laptop))
        else:
            self._join(laptop)

    def _fault_teacher_killed(self, fault: Fault) -> str:
        if self._teacher_is_faulty:
            return "already"
        self._teacher_is_faulty = True
        os.kill(hub_pid(self._testbed.teacher), signal.SIGKILL)
        self._later.add(4 * fault.size, self._open_class_again)
        return f"for {4 * fault.size:.1f} s"

    def _open_class_again(self) -> None:
        self._open_class()

    def _fault_teacher_stopped(self, fault: Fault) -> str:
        if self._teacher_is_faulty:
            return "already"
        self._teacher_is_faulty = True
        pid = hub_pid(self._testbed.teacher)
        os.kill(pid, signal.SIGSTOP)

        def go_on() -> None:
            os.kill(pid, signal.SIGCONT)
            self._teacher_is_faulty = False
            self._teacher_since = time.monotonic()

        self._later.add(0.5 + 3 * fault.size, go_on)
        return f"for {0.5 + 3 * fault.size:.1f} s"


def run_class(folder: Path, seed: str, seconds: float, report: Report, stall: StallMeter) -> None:  # noqa: ARG001 - as run_domain
    """Run the chaos in a class of 4 laptops with 3 nodes each."""
    missing = missing_requirement()
    if missing is not None:
        report.note(f"no class: {missing}")
        return
    with LanTestbed(_LAPTOPS) as testbed:
        ClassChaos(testbed, seed, seconds, report, stall).run()
