"""Ring of nodes in one domain, and what an observer must see of it."""

from __future__ import annotations

import dataclasses
import signal
import time
from typing import TYPE_CHECKING, Any

from tests.conftest import wait_until

if TYPE_CHECKING:
    from tests.torture.processes import Process, Processes
    from tests.torture.report import Report
    from tests.torture.stall import StallMeter

TRUE_LIST_S = 3.0  #: the time within which lists become true
START_S = 3.0
SILENCE_S = 3.0  #: a node that works has a heartbeat within this time
END_S = 1.0
_OBSERVER_SILENCE_S = 3.0
_WARM_UP_S = 20.0
_MOST_GROWTH_BYTES = 12 * 2**20
_MOST_NEW_DESCRIPTORS = 12


@dataclasses.dataclass(eq=False)
class Member:
    """A node of the ring, with its present process."""

    index: int
    process: Process | None = None
    since: float = 0.0  #: when its state changed last, in monotonic seconds
    is_faulty: bool = False  #: whether a fault holds, so that nothing is promised of it
    reported: set[str] = dataclasses.field(default_factory=set)
    usage: list[tuple[float, int, int]] = dataclasses.field(default_factory=list)

    @property
    def name(self) -> str:
        """The name of its node."""
        return f"ring{self.index}"

    def change(self) -> None:
        """Note that its state has changed now."""
        self.since = time.monotonic()
        self.reported.clear()


class Ring:
    """Ring of nodes, and the observer of its domain.

    Args:
        processes: The processes of the run.
        size: The number of nodes.
        report: Takes what breaks a promise.
        stall: Extends the limits of time on a busy machine.
        variables: Environment variables of the nodes.
    """

    def __init__(
        self,
        processes: Processes,
        size: int,
        report: Report,
        stall: StallMeter,
        variables: dict[str, str] | None = None,
    ) -> None:
        self.processes, self.report, self.stall = processes, report, stall
        self._variables = variables or {}
        self.members = [Member(index) for index in range(size)]
        self.runs: list[tuple[Member, Process]] = []
        self.observer = processes.start("observer", "observer.py")
        self.seen_at = time.monotonic()
        self.router_fault_at = 0.0  #: the nodes that are clients of the router depend on it
        for member in self.members:
            self.start(member)
        for member in self.members:
            if member.process is None or member.process.wait_for("ready", 30) is None:
                report.violation(f"{member.name} did not start")
            member.change()

    # -- nodes -----------------------------------------------------------------------------------

    def start(self, member: Member) -> None:
        """Start a member's process."""
        own, neighbour = str(member.index), str((member.index - 1) % len(self.members))
        member.process = self.processes.start(
            member.name, "ring_node.py", member.name, own, neighbour, **self._variables
        )
        member.usage.clear()
        member.is_faulty = False
        self.runs.append((member, member.process))
        member.change()

    def forget(self, member: Member) -> None:
        """Note that a member's process has ended on purpose."""
        member.process = None
        member.change()

    def end(self, member: Member, number: int) -> None:
        """End a member with SIGINT or SIGTERM, and check that it ends in time."""
        process = member.process
        if process is None:
            return
        member.is_faulty = True
        begin = time.monotonic()
        process.signal(number)
        process.signal(signal.SIGCONT)  # a delay may have suspended it
        code = process.wait(10 * END_S)
        took_s = time.monotonic() - begin
        if code is None or took_s > self.stall.allowed(END_S, begin):
            self.report.violation(f"{member.name} needed {took_s:.2f} s to end after {number}")
        if code is None:
            process.signal(9)
            process.wait(5)
        elif code != 0:
            self.report.violation(f"{member.name} ended with {code} after {number}")
        self.forget(member)

    # -- promises --------------------------------------------------------------------------------

    def check(self) -> None:
        """Compare what the observer sees with what is so."""
        seen = self.observer.last_fact()
        now = time.monotonic()
        if seen:
            self.seen_at = max(self.seen_at, seen["time"])
        allowed_s = self.stall.allowed(_OBSERVER_SILENCE_S, self.seen_at)
        if now - self.seen_at > allowed_s:
            self.report.violation(f"the observer has said nothing for {now - self.seen_at:.1f} s")
            self.seen_at = now
        for member in self.members:
            if not member.is_faulty:
                self._check_member(member, seen)

    def _check_member(self, member: Member, seen: dict[str, Any]) -> None:
        process = member.process
        if process is not None and process.exit_code is not None:
            self.report.violation(f"{member.name} ended with {process.exit_code}: {process.output}")
            self.forget(member)
            return
        # The observer's line is from a moment ago, and it must have been true then.
        is_listed = member.name in seen.get("nodes", [])
        since = max(member.since, self.router_fault_at)
        waited_s = seen.get("time", 0.0) - since
        if is_listed is (process is not None):
            if "list" in member.reported:
                self.report.note(f"the list is right about {member.name} after {waited_s:.1f} s")
                member.reported.discard("list")
        elif waited_s > self.stall.allowed(TRUE_LIST_S, since):
            word = "still listed" if is_listed else "not listed"
            self._report_once(member, "list", f"{member.name} is {word} after {waited_s:.1f} s")
        if process is None:
            return
        beat = seen.get("beats", {}).get(member.name, {})
        last = max(since, beat.get("time", 0.0))
        if seen.get("time", 0.0) - last > self.stall.allowed(SILENCE_S, last):
            self._report_once(member, "beat", f"{member.name} is silent since {last:.1f}")

    def _report_once(self, member: Member, what: str, text: str) -> None:
        if what not in member.reported:
            member.reported.add(what)
            self.report.violation(text)

    def measure(self) -> None:
        """Note the memory and the descriptors of each process."""
        now = time.monotonic()
        for member in self.members:
            if member.process is not None and now - member.process.started > _WARM_UP_S:
                member.usage.append((now, *member.process.usage()))

    def check_growth(self) -> None:
        """Compare the memory and the descriptors at the end with those after the start.

        A node that starts while others are dead has few links. So all nodes are compared with the
        node that had the most after its start.
        """
        used = {member: [usage for usage in member.usage if usage[1]] for member in self.members}
        used = {member: usages for member, usages in used.items() if len(usages) >= 8}
        begins = [usages[: len(usages) // 4] for usages in used.values()]
        for column, what, most in (
            (1, "bytes", _MOST_GROWTH_BYTES),
            (2, "descriptors", _MOST_NEW_DESCRIPTORS),
        ):
            first = max((usage[column] for begin in begins for usage in begin), default=0)
            for member, usages in used.items():
                last = min(usage[column] for usage in usages[-(len(usages) // 4) :])
                if last - first > most:
                    text = f"{member.name} has {last} {what}, at first {first}"
                    kept = "" if member.process is None else member.process.descriptors()
                    self.report.violation(f"{text} ({kept})")

    def gaps(self) -> list[tuple[Member, dict[str, Any], bool]]:
        """Return what the nodes missed: who, the gap, and whether both ends are in the mesh."""
        in_mesh = {
            facts["run"]: facts["is_in_mesh"]
            for _, process in self.runs
            for facts in process.facts("ready")
        }
        found = []
        for member, process in self.runs:
            own = next((facts["is_in_mesh"] for facts in process.facts("ready")), False)
            found += [
                (member, gap, own and in_mesh.get(gap["run"], False))
                for gap in process.facts("gap")
            ]
        return found

    def received(self) -> tuple[int, int]:
        """Return how many messages the nodes sent and received that ended with a signal."""
        ends = [facts for _, process in self.runs for facts in process.facts("end")]
        return sum(end["sent"] for end in ends), sum(end["received"] for end in ends)

    def is_flowing(self) -> bool:
        """Return whether each node receives the newest words of its neighbour."""
        beats = self.observer.last_fact().get("beats", {})
        for member in self.members:
            own = beats.get(member.name, {})
            before = beats.get(self.members[member.index - 1].name, {})
            run, number = own.get("last", ("", 0))
            if run != before.get("run") or before.get("sent", 0) - number > 20:
                return False
        return True

    def settle(self) -> None:
        """Wait until all is calm, and check that nothing stays behind."""
        if not wait_until(self.is_flowing, 20.0):
            beats = self.observer.last_fact().get("beats", {})
            self.report.violation(f"the words do not flow any more: {beats}")
