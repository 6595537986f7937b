"""A student who wants too much, in a class: `python -m tests.torture.class_attacks --seconds 600`.

The class has a teacher, who hears another student's messages, 100 a second. How long these take
is printed, and the memory of the hubs and of the routers: before an attack, during it, and a minute
after it. Needs Linux and root.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import signal
import sys
import tempfile
import time
from pathlib import Path

from tests.classroom.lesson import Lesson
from tests.classroom.testbed import LanTestbed, missing_requirement
from tests.torture.client_attacks import BACK_S, LEAST_MS, MOST_BACK, MOST_MEMORY, MOST_TIMES
from tests.torture.processes import PROGRAMS, clean_end, memory_mb
from tests.torture.programs.class_attacker import ATTACKS
from tests.torture.report import Report, percentile
from tests.torture.stall import StallMeter

_ROLES = {"zbot.classroom": "hub", "zbot.transport": "router"}
_ALONE_S = 20.0

Memory = dict[str, float]  #: MB of each hub and router, by machine and role


class ClassAttack:
    """Class of an attacker and an honest student.

    Args:
        testbed: The machines.
        report: Takes the figures, and what breaks a promise.
    """

    def __init__(self, testbed: LanTestbed, report: Report) -> None:
        self._testbed, self._report = testbed, report
        self._attacker, honest = testbed.laptops
        lesson = Lesson(testbed, 1)
        lesson.join()
        domain = lesson.number_of(honest)
        self._hear = testbed.teacher.start("hear.py", f"{domain}/ana/words")
        self._hear.wait_for("hearing")
        honest.start("pupil.py", "ana", "ana", "--hz", "100").wait_for("hears")

    def run(self, kind: str, seconds: float) -> None:
        """Attack, and check the figures."""
        # It does nothing: with it, the attacker's machine has a router before the attack, too.
        self._attacker.start("pupil.py", "quiet", "quiet", "--hz", "1").wait_for("hears")
        time.sleep(_ALONE_S)
        before = self._memory()
        begin = time.monotonic()
        attack = self._attacker.start(str(PROGRAMS / "class_attacker.py"), kind)
        attack.wait_for("attacks")
        self._give_own_processor()
        most = self._most_memory(begin + seconds)
        attack.process.kill()
        attack.process.wait()
        end = time.monotonic()
        while time.monotonic() < end + BACK_S and not _is_back(before, self._memory()):
            time.sleep(0.5)
        self._check(kind, before, most, self._memory())
        self._check_times(kind, begin, end)

    def _give_own_processor(self) -> None:
        """Let the attacker's machine use one processor, and the others the rest."""
        *rest, last = sorted(os.sched_getaffinity(0))
        for machine in self._testbed.machines:
            chosen = {last} if machine is self._attacker else rest or {last}
            for pid in machine.processes():
                for task in Path(f"/proc/{pid}/task").iterdir():
                    with contextlib.suppress(OSError):  # it has ended meanwhile
                        os.sched_setaffinity(int(task.name), chosen)

    def _most_memory(self, until: float) -> Memory:
        most = Memory()
        while time.monotonic() < until:
            for name, value in self._memory().items():
                most[name] = max(value, most.get(name, 0.0))
            time.sleep(0.5)
        return most

    def _memory(self) -> Memory:
        found = Memory()
        for machine in self._testbed.machines:
            for pid in machine.processes():
                with contextlib.suppress(OSError):  # it has ended meanwhile
                    words = Path(f"/proc/{pid}/cmdline").read_text(encoding="utf-8").split("\0")
                    for role in (_ROLES[word] for word in words if word in _ROLES):
                        found[f"{role} of {machine.name}"] = memory_mb(pid)
        return found

    def _check(self, kind: str, before: Memory, most: Memory, back: Memory) -> None:
        for name, start in before.items():
            figures = start, most.get(name, 0.0), back.get(name, 0.0)
            self._report.note("{}: {}: {:.0f}, {:.0f}, {:.0f} MB".format(kind, name, *figures))
            self._report.limit(f"{kind}: {name}", figures[1], MOST_MEMORY * start, "MB")
            self._report.limit(
                f"{kind}: {name}", figures[2], MOST_BACK * start, "MB a minute later"
            )

    def _check_times(self, kind: str, begin: float, end: float) -> None:
        self._hear.process.send_signal(signal.SIGINT)
        self._hear.wait(20)
        beats: dict[str, list[int]] = json.loads(self._hear.lines[-1])["delays_us"]
        alone = [us for beat, all_us in beats.items() if int(beat) < int(begin) for us in all_us]
        under = [us for beat, all_us in beats.items() if begin < int(beat) < end for us in all_us]
        alone_ms, under_ms = percentile(alone, 0.99) / 1000, percentile(under, 0.99) / 1000
        received = len(under) / (end - begin)
        self._report.note(
            f"{kind}: {alone_ms:.1f} ms, then {under_ms:.1f} ms, {received:.0f} messages a second"
        )
        self._report.limit(kind, under_ms, max(MOST_TIMES * alone_ms, LEAST_MS), "ms")


def _is_back(before: Memory, now: Memory) -> bool:
    return all(now.get(name, 0.0) < MOST_BACK * start for name, start in before.items())


def main() -> int:
    parser = argparse.ArgumentParser(description="A student who wants too much.")
    parser.add_argument("--seconds", type=float, default=600, help="time of each attack")
    parser.add_argument("--only", default="", help="only attacks whose name has this text")
    given = parser.parse_args()
    missing = missing_requirement()
    if missing is not None:
        print(f"no class: {missing}")
        return 1
    folder, report = Path(tempfile.mkdtemp(prefix="zbot-class-attacks-")), Report()
    with clean_end(), StallMeter() as stall, report.until_interrupted():
        for kind in ATTACKS:
            if given.only in kind:
                with LanTestbed(2) as testbed:
                    ClassAttack(testbed, report).run(kind, given.seconds)
    again = f"python -m tests.torture.class_attacks --seconds {given.seconds:g}"
    return report.end(again, folder, stall)


if __name__ == "__main__":
    sys.exit(main())
