"""Changes of period in a class: `python -m tests.torture.periods --rounds 20 --students 30`.

In each round, all students leave the class, and as many others join it on other laptops, within 5 s
and in a random order. Everybody must then be linked, and the teacher must see everybody. Needs
Linux and root.
"""

from __future__ import annotations

import argparse
import json
import secrets
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING

from tests.classroom.testbed import LanTestbed, missing_requirement
from tests.torture.processes import clean_end
from tests.torture.report import Report, times
from tests.torture.stall import StallMeter

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tests.classroom.machine import Finished, Machine

_PIN = "4711"
_TIMEOUT_S = 120.0
_KEPT = "may keep number"  #: of `zbot leave`, if the class did not answer in time


class Periods:
    """Class whose students change.

    Args:
        testbed: The machines. Half of the laptops are in the class at a time.
        seed: Text for the random order.
        within_s: Time in which all commands of a round begin.
        report: Takes what breaks a promise.
    """

    def __init__(self, testbed: LanTestbed, seed: str, within_s: float, report: Report) -> None:
        self._testbed, self._within_s, self._report = testbed, within_s, report
        self._random = Random(seed)
        self._joined_s: list[float] = []
        self._kept: set[str] = set()  # laptops whose number the class may keep, as they were told
        self._is_interrupted = False
        half = len(testbed.laptops) // 2
        self._groups = testbed.laptops[:half], testbed.laptops[half:]
        opened = self._run(testbed.teacher, "class", "start", "Robots", "--pin", "--json")
        self._code = str(json.loads(opened.out)["code"])

    def run(self, rounds: int) -> None:
        """Let the students change. The first group joins before the first round."""
        try:
            self._run_rounds(rounds)
        except KeyboardInterrupt:
            self._is_interrupted = True  # the end of the testbed kills the commands
            raise
        self._report.note(f"`zbot join`: {times(self._joined_s)}")

    def _run_rounds(self, rounds: int) -> None:
        self._change((), self._groups[0])
        for number in range(1, rounds + 1):
            leaving, joining = self._groups[(number - 1) % 2], self._groups[number % 2]
            begin = time.monotonic()
            self._change(leaving, joining)
            self._check(joining)
            self._report.note(f"round {number}: {time.monotonic() - begin:.1f} s")

    def _change(self, leaving: Sequence[Machine], joining: Sequence[Machine]) -> None:
        work = [(laptop, "leave") for laptop in leaving] + [
            (laptop, "join", self._code) for laptop in joining
        ]
        self._random.shuffle(work)
        with ThreadPoolExecutor(len(work)) as pool:
            for machine, *words in work:
                pool.submit(self._run, machine, *words)
                time.sleep(self._within_s / len(work))

    def _check(self, joined: Sequence[Machine]) -> None:
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(self._check_linked, joined))
        listed = self._run(self._testbed.teacher, "class", "list", "--json")
        students = json.loads(listed.out)["students"] if listed.code == 0 else []
        names = {laptop.name for laptop in joined}
        here = {student["host"] for student in students if student["here"]}
        away = {student["host"] for student in students if not student["here"]}
        if here != names or len(students) != len(here | away) or away - self._kept:
            self._report.violation(
                f"the teacher does not see {sorted(names - here)}, sees {sorted(here - names)}, "
                f"and lists {len(students)} students, of which {sorted(away)} are away"
            )

    def _check_linked(self, machine: Machine) -> None:
        state = self._run(machine, "status", "--json")
        if self._is_interrupted:
            return
        if state.code or not json.loads(state.out)["linked"] or json.loads(state.out)["problem"]:
            self._report.violation(f"{machine.name} is not linked: {state.out}")

    def _run(self, machine: Machine, *words: str) -> Finished:
        done = machine.run("zbot", *words, env={"ZBOT_PIN": _PIN}, timeout_s=_TIMEOUT_S)
        if words[0] == "join":
            self._joined_s.append(done.took_s)
            self._kept.discard(machine.name)
        elif _KEPT in done.err:
            self._report.count("laptops that were told that the class may keep their number")
            self._kept.add(machine.name)
        if (done.code or "Traceback" in done.err) and not self._is_interrupted:
            text = f"{machine.name}: `zbot {' '.join(words)}` ended with {done.code}"
            self._report.violation(f"{text}: {done.err.strip()[-300:]}")
        return done


def main() -> int:
    parser = argparse.ArgumentParser(description="Changes of period in a class.")
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--students", type=int, default=30)
    parser.add_argument("--within", type=float, default=5.0, help="seconds of a round")
    parser.add_argument("--seed", default="", help="text; the same seed makes the same order")
    given = parser.parse_args()
    seed = given.seed or secrets.token_hex(4)
    print(f"seed {seed}, {given.rounds} rounds with {given.students} students", flush=True)
    missing = missing_requirement()
    if missing is not None:
        print(f"no class: {missing}")
        return 1
    folder, report = Path(tempfile.mkdtemp(prefix="zbot-periods-")), Report()
    with (
        clean_end(),
        StallMeter() as stall,
        report.until_interrupted(),
        LanTestbed(2 * given.students) as testbed,
    ):
        Periods(testbed, seed, given.within, report).run(given.rounds)
    options = f"--rounds {given.rounds} --students {given.students} --within {given.within:g}"
    return report.end(f"python -m tests.torture.periods {options} --seed {seed}", folder, stall)


if __name__ == "__main__":
    sys.exit(main())
