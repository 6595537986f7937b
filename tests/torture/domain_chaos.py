"""Faults in a domain of many nodes on one machine."""

from __future__ import annotations

import contextlib
import os
import signal
import struct
import subprocess
import sys
import time
from functools import partial
from typing import TYPE_CHECKING

from tests.torture.faults import Fault, Schedule, plan
from tests.torture.processes import PROGRAMS
from tests.torture.report import times
from tests.torture.ring import START_S, Ring

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from tests.torture.processes import Process, Processes
    from tests.torture.report import Report
    from tests.torture.ring import Member
    from tests.torture.stall import StallMeter

NODES = 20
#: The first nodes are never ended, so that their memory can be watched.
_LASTING = 4
_PAUSE_S = 1.5
_LIST_PERIOD_S = 7.0
_LIST_S = 1.0  #: a command works within this time
_MEASURE_PERIOD_S = 2.0
_CALM_S = 12.0  #: at the end without faults
#: A node that is a client of the router may lose messages this long after a fault of the router.
_ROUTER_S = 5.0
_SETTINGS_SIZE = "256k"
_KINDS = {
    "kill": 5.0,
    "end": 3.0,
    "stop": 4.0,
    "delay": 2.0,
    "router killed": 2.0,
    "router stopped": 2.0,
    "router paused": 2.0,
    "clock": 2.0,
    "disk": 1.0,
    "descriptors": 2.0,
}


def clock_library(folder: Path) -> Path | None:
    """Compile the library that lets clocks jump. Return None if there is no compiler."""
    built = folder / "clock_jump.so"
    words = ["cc", "-shared", "-fPIC", "-O2", "-o", str(built), str(PROGRAMS / "clock_jump.c")]
    try:
        subprocess.run(words, check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return built


@contextlib.contextmanager
def small_disk(folder: Path) -> Iterator[bool]:
    """Mount a small file system on a folder. The block gets whether that was possible."""
    words = ["mount", "-t", "tmpfs", "-o", f"size={_SETTINGS_SIZE}", "zbot-chaos", str(folder)]
    is_mounted = subprocess.run(words, capture_output=True, check=False).returncode == 0
    try:
        yield is_mounted
    finally:
        if is_mounted:
            subprocess.run(["umount", "-l", str(folder)], capture_output=True, check=False)


class DomainChaos:
    """Chaos in a domain.

    Args:
        processes: The processes of the run.
        seed: Text.
        seconds: How long faults occur.
        report: Takes what breaks a promise.
        stall: Extends the limits of time on a busy machine.
        has_disk: Whether the settings are on a small disk of their own.
    """

    def __init__(
        self,
        processes: Processes,
        seed: str,
        seconds: float,
        report: Report,
        stall: StallMeter,
        *,
        has_disk: bool,
    ) -> None:
        self.processes, self.report, self.stall = processes, report, stall
        self._seconds = seconds
        self._clock = processes.folder / "clock"
        self._clock.write_bytes(struct.pack("d", 0.0))
        library = clock_library(processes.folder)
        kinds = dict(_KINDS)
        if not has_disk:
            kinds.pop("disk")
            report.note("no full disk: a small file system needs root")
        variables = {}
        if library is None:
            kinds.pop("clock")
            report.note("no clock jumps: there is no C compiler `cc`")
        else:
            variables = {"LD_PRELOAD": str(library), "CLOCK_OFFSET_FILE": str(self._clock)}
        self._plan = plan(f"{seed}/domain", kinds, seconds, _PAUSE_S)
        self._later = Schedule()
        self._router_faults: list[float] = []
        self._list_times: list[float] = []
        self._start_times: list[float] = []
        self._starting: list[tuple[Member, Process]] = []
        self._lists: list[Process] = []
        self.ring = Ring(processes, NODES, report, stall, variables)

    # -- the run ---------------------------------------------------------------------------------

    def run(self) -> None:
        """Let the faults of the plan occur, and check the promises meanwhile."""
        begin = time.monotonic()
        for fault in self._plan:
            self._later.add(fault.at_s, partial(self._begin_fault, fault))
        self._later.add(_LIST_PERIOD_S, self._start_list)
        measured = begin
        while time.monotonic() < begin + self._seconds + _CALM_S:
            self._later.run_due()
            self._check_starts()
            self._check_lists()
            self.ring.check()
            if time.monotonic() > measured + _MEASURE_PERIOD_S:
                measured = time.monotonic()
                self.ring.measure()
            time.sleep(0.1)
        self._end(begin)

    def _end(self, begin: float) -> None:
        self.ring.settle()
        self.ring.check_growth()
        for member in self.ring.members:
            self.ring.end(member, signal.SIGINT)
        self._check_gaps()
        for fault in self.processes.faults():
            self.report.violation(fault)
        sent, received = self.ring.received()
        note = self.report.note
        note(f"domain: {len(self._plan)} faults in {time.monotonic() - begin:.0f} s")
        note(f"domain: {sent} messages sent and {received} received by nodes that ended in order")
        note(f"domain: new nodes: {times(self._start_times)}")
        note(f"domain: `zbot node list`: {times(self._list_times)}")

    def _begin_fault(self, fault: Fault) -> None:
        self.report.count(fault.kind)
        name = fault.kind.replace(" ", "_")
        act: Callable[[Fault], str] = getattr(self, f"_fault_{name}")
        done = act(fault)
        self.report.note(f"domain: {fault.kind} {done}")

    def _victim(self, fault: Fault, first: int = 0) -> Member | None:
        able = [
            member
            for member in self.ring.members[first:]
            if member.process is not None and not member.is_faulty and member.process.facts("ready")
        ]
        return able[fault.victim % len(able)] if able else None

    # -- faults of nodes -------------------------------------------------------------------------

    def _fault_kill(self, fault: Fault) -> str:
        return self._end_and_restart(fault, signal.SIGKILL)

    def _fault_end(self, fault: Fault) -> str:
        return self._end_and_restart(fault, (signal.SIGINT, signal.SIGTERM)[fault.victim % 2])

    def _end_and_restart(self, fault: Fault, number: int) -> str:
        member = self._victim(fault, _LASTING)
        if member is None or member.process is None:
            return "nobody"
        if number == signal.SIGKILL:
            member.process.signal(number)
            member.process.wait(5)
            self.ring.forget(member)
        else:
            self.ring.end(member, number)
        self._later.add(4 * fault.size, partial(self._restart, member))
        return f"{member.name} for {4 * fault.size:.1f} s"

    def _restart(self, member: Member) -> None:
        self.ring.start(member)
        if member.process is not None:
            member.is_faulty = True  # until it is ready
            self._starting.append((member, member.process))

    def _check_starts(self) -> None:
        for member, process in self._starting[:]:
            ready = process.facts("ready")
            waited_s = time.monotonic() - process.started
            if ready:
                self._start_times.append(ready[0]["time"] - process.started)
                waited_s = self._start_times[-1]
            elif process.exit_code is None and waited_s < 10 * START_S:
                continue
            if not ready or waited_s > self.stall.allowed(START_S, process.started):
                self.report.violation(
                    f"{member.name} started in {waited_s:.1f} s: {process.output}"
                )
            self._starting.remove((member, process))
            member.is_faulty = False
            member.change()

    def _fault_stop(self, fault: Fault) -> str:
        return self._stop(fault, 0.1 + 6 * fault.size**2)

    def _stop(self, fault: Fault, seconds: float) -> str:
        member = self._victim(fault)
        if member is None or member.process is None:
            return "nobody"
        member.is_faulty = True
        member.process.signal(signal.SIGSTOP)
        self._later.add(seconds, partial(self._continue, member))
        return f"{member.name} for {seconds:.1f} s"

    def _continue(self, member: Member) -> None:
        if member.process is not None:
            member.process.signal(signal.SIGCONT)
        member.is_faulty = False
        member.change()

    def _fault_delay(self, fault: Fault) -> str:
        """Stop and continue a node again and again, so that all it does is late."""
        member = self._victim(fault)
        if member is None or member.process is None:
            return "nobody"
        times_, process = 10 + int(40 * fault.size), member.process
        for number in range(times_):
            self._later.add(0.05 * number, partial(process.signal, signal.SIGSTOP))
            self._later.add(0.05 * number + 0.04, partial(process.signal, signal.SIGCONT))
        return f"{member.name} {times_} times by 40 ms"

    def _fault_descriptors(self, fault: Fault) -> str:
        member = self._victim(fault)
        if member is None or member.process is None:
            return "nobody"
        pid = member.process.pid
        before = _limit_descriptors(pid)
        used = member.process.usage()[1]
        _limit_descriptors(pid, (max(1, used - 1), before[1]))
        seconds = 0.5 + 4 * fault.size
        self._later.add(seconds, partial(_restore_limit, pid, before))
        return f"{member.name} has no more than {used} for {seconds:.1f} s"

    # -- faults of the router --------------------------------------------------------------------

    def _router(self) -> int | None:
        for path in self.processes.settings.glob("zbot/router-*.lock"):
            with contextlib.suppress(OSError, ValueError):
                number = int(path.read_text(encoding="utf-8"))
                if number in self.processes.ids():
                    return number
        return None

    def _signal_router(self, *steps: tuple[float, int]) -> str:
        router = self._router()
        if router is None:
            return "nobody"
        for delay_s, number in steps:
            self._later.add(delay_s, partial(self._signal, router, number))
        return f"{router}"

    def _signal(self, pid: int, number: int) -> None:
        if pid in self.processes.ids():
            self.ring.router_fault_at = time.monotonic()
            self._router_faults.append(self.ring.router_fault_at)
            os.kill(pid, number)

    def _fault_router_killed(self, _: Fault) -> str:
        return self._signal_router((0, signal.SIGKILL))

    def _fault_router_stopped(self, _: Fault) -> str:
        return self._signal_router((0, signal.SIGSTOP))

    def _fault_router_paused(self, fault: Fault) -> str:
        return self._signal_router((0, signal.SIGSTOP), (2 * fault.size, signal.SIGCONT))

    # -- faults of the machine -------------------------------------------------------------------

    def _fault_clock(self, fault: Fault) -> str:
        """Let the clocks of all nodes jump by up to a year, forwards or backwards."""
        jump = (1 if fault.victim % 2 else -1) * 10 ** (7.5 * fault.size)
        with self._clock.open("r+b") as file:  # the nodes have mapped this file
            file.write(struct.pack("d", jump))
        return f"of all nodes by {jump:+.0f} s"

    def _fault_disk(self, fault: Fault) -> str:
        """Fill the disk of the settings. Meanwhile a node is killed and another starts."""
        path = self.processes.settings / "ballast"
        with contextlib.suppress(OSError), path.open("wb", buffering=0) as file:
            while True:
                file.write(bytes(4096))
        seconds = 1 + 5 * fault.size
        self._end_and_restart(fault._replace(size=0.1 * fault.size), signal.SIGKILL)
        self._later.add(seconds, partial(path.unlink, missing_ok=True))
        return f"is full for {seconds:.1f} s"

    # -- other checks ----------------------------------------------------------------------------

    def _start_list(self) -> None:
        self._lists.append(self.processes.start("list", "zbot", "node", "list"))
        self._later.add(_LIST_PERIOD_S, self._start_list)

    def _check_lists(self) -> None:
        for process in self._lists[:]:
            code = process.exit_code
            took_s = time.monotonic() - process.started
            if code is None and took_s < self.stall.allowed(10 * _LIST_S, process.started):
                continue
            self._lists.remove(process)
            self._list_times.append(took_s)
            if code != 0 or took_s > self.stall.allowed(_LIST_S, process.started) + 0.1:
                self.report.violation(
                    f"`zbot node list` ended with {code} after {took_s:.2f} s: {process.output}"
                )

    def _check_gaps(self) -> None:
        told = 0
        for member, gap, is_in_mesh in self.ring.gaps():
            excused = not is_in_mesh and any(
                0 <= gap["time"] - fault <= self.stall.allowed(_ROUTER_S, fault)
                for fault in self._router_faults
            )
            told += excused
            if not excused:
                self.report.violation(f"{member.name} missed messages: {gap}")
        self.report.note(
            f"domain: {told} gaps of clients of the router, after faults of the router"
        )


def _limit_descriptors(pid: int, *limits: tuple[int, int]) -> tuple[int, int]:
    """Set the limits of a process's descriptors, if some are given. Return those before."""
    if sys.platform != "linux":
        raise NotImplementedError("only Linux sets limits of other processes")
    import resource  # noqa: PLC0415 - POSIX only

    return resource.prlimit(pid, resource.RLIMIT_NOFILE, *limits)


def _restore_limit(pid: int, limits: tuple[int, int]) -> None:
    with contextlib.suppress(ProcessLookupError):
        _limit_descriptors(pid, limits)
