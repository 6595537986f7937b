"""Random ends of programs: `python -m tests.torture.random_ends --runs 1000`.

Programs of several kinds get SIGINT, SIGTERM or SIGUSR1 at random moments: while Python starts,
while modules are imported, while the session opens, and while they work. Each must end within a
second, without a traceback. The seed is printed: the same seed makes the same signals and moments.
"""

from __future__ import annotations

import argparse
import secrets
import signal
import sys
import tempfile
import time
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING, NamedTuple

from tests.torture.processes import PROGRAMS, ROOT, Process, Processes, clean_end
from tests.torture.report import Report, times
from tests.torture.stall import StallMeter
from zbot.testing.domain import reserved_domain

if TYPE_CHECKING:
    from collections.abc import Iterator

_END_S = 1.0
_HANG_S = 10.0
_PARALLEL = 2
_LATEST_S = 2.5  #: the latest moment of a signal
#: A traceback without a file of these folders is of Python itself, which had not reached zbot yet.
_FOLDERS = tuple(str(ROOT / name) + "/" for name in ("zbot", "cli", "nodes"))
_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1)
_PLAIN = "plain"  #: started as `python program.py`
_PROGRAMS: dict[str, tuple[str, ...]] = {
    "talker": ("zbot", "run", "talker"),
    "listener": ("zbot", "run", "listener"),
    "service": ("zbot", "run", "add_two_ints_server"),
    "action": ("zbot", "run", "fibonacci_action_server"),
    "ring": ("zbot", "run", str(PROGRAMS / "ring_node.py"), "ring0", "0", "0"),
    _PLAIN: ("ring_node.py", "ring0", "0", "0"),
    "echo": ("zbot", "topic", "echo", "/chatter"),
    "list": ("zbot", "node", "list"),
    "hz": ("zbot", "topic", "hz", "/chatter"),
    "launch": ("zbot", "launch", "{launch}"),
    "record": ("zbot", "bag", "record", "--all", "--output", "{new}"),
    "view": ("zbot", "view", "--no-browser", "--port", "0"),
    "web": ("zbot", "web", "--no-browser", "--port", "0"),
    "foxglove": ("zbot", "foxglove", "--port", "0"),
    "sim": ("zbot", "sim", "--headless"),
}
_LAUNCH = """
launch:
- node: {pkg: demo_nodes_py, exec: talker, name: one}
- node: {pkg: demo_nodes_py, exec: listener, name: two}
"""


class End(NamedTuple):
    """One run of a program."""

    program: str
    number: signal.Signals
    moment_s: float


def ends(seed: str, runs: int) -> Iterator[End]:
    """Yield the runs of a seed."""
    random = Random(seed)
    for _ in range(runs):
        # A third of the signals comes in the first 0.3 s, in which modules are imported.
        moment_s = random.uniform(0, random.choice((0.3, 0.6, _LATEST_S)))
        yield End(random.choice(list(_PROGRAMS)), random.choice(_SIGNALS), moment_s)


def is_of_import(text: str) -> bool:
    """Return whether a traceback shows that Ctrl-C came during an import, and before `init()`.

    After `init()`, Ctrl-C raises another exception. Python may print notes after the traceback. It
    leaves out its own lines if they only call the module's code.
    """
    if "\nKeyboardInterrupt\n" not in f"{text}\n":
        return False
    tracebacks = text.split("Traceback (most recent call last):")
    is_in_module = any(traceback.count(", in <module>") > 1 for traceback in tracebacks)
    return is_in_module or "<frozen importlib._bootstrap>" in text


class RandomEnds:
    """Programs that end at random moments."""

    def __init__(self, processes: Processes, report: Report, stall: StallMeter) -> None:
        self._processes, self._report, self._stall = processes, report, stall
        self._launch = processes.folder / "two.yaml"
        self._launch.write_text(_LAUNCH, encoding="utf-8")
        self.took_s: list[float] = []

    def run(self, some: list[End]) -> None:
        """Start some programs at once, send each its signal, and check their ends."""
        started = [(end, self._start(end)) for end in some]
        for end, process in sorted(started, key=lambda pair: pair[0].moment_s):
            time.sleep(max(0.0, process.started + end.moment_s - time.monotonic()))
            if process.exit_code is None:
                process.signal(end.number)
                self._check(end, process)
            else:
                self._check_code(end, process)

    def _start(self, end: End) -> Process:
        new = self._processes.folder / f"bag-{len(self._processes.all)}"
        paths = {"{launch}": str(self._launch), "{new}": str(new)}
        words = [paths.get(word, word) for word in _PROGRAMS[end.program]]
        return self._processes.start(end.program, *words)

    def _check(self, end: End, process: Process) -> None:
        begin = time.monotonic()
        code = process.wait(_HANG_S)
        if code is None and self._was_lost_by_python(process):
            self._report.count("Ctrl-C that Python lost before it reached zbot")
            begin = time.monotonic()
            process.signal(end.number)
            code = process.wait(_HANG_S)
        took_s = time.monotonic() - begin
        self.took_s.append(took_s)
        if code is None:
            self._report.violation(f"{end} hangs: {process.output}")
            process.signal(signal.SIGKILL)
            process.wait(5)
        elif took_s > self._stall.allowed(_END_S, begin):
            self._report.violation(f"{end} needed {took_s:.2f} s: {process.output}")
        self._check_code(end, process)

    @staticmethod
    def _was_lost_by_python(process: Process) -> bool:
        """Return whether Python dropped `KeyboardInterrupt` in a weak reference of its imports.

        zbot's programs and commands raise it again, but only after zbot itself was imported.
        """
        text = process.text()
        is_lost = text.startswith("Exception ignored in") and "KeyboardInterrupt" in text
        return is_lost and not any(folder in text for folder in _FOLDERS)

    def _check_code(self, end: End, process: Process) -> None:
        code = process.exit_code
        allowed = {0, 1, 128 + end.number, -end.number}
        if code is not None and code not in allowed:
            self._report.violation(f"{end} ended with {code}: {process.output}")
        self._report.count(f"ended with {code}")

    def check_outputs(self) -> None:
        """Check that no program has printed a traceback.

        Python prints one at Ctrl-C while it starts, and while `python program.py` imports modules.
        `zbot run program.py` prints none.
        """
        for process in self._processes.all:
            found, text = process.faults(), process.text()
            if found and not any(folder in text for folder in _FOLDERS):
                self._report.count("tracebacks of Python before it reached zbot")
            elif found and process.name == _PLAIN and is_of_import(text):
                self._report.count("tracebacks of `python program.py` during its imports")
            else:
                for fault in found:
                    self._report.violation(fault)


def main() -> int:
    parser = argparse.ArgumentParser(description="End programs at random moments.")
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--seed", default="", help="text; the same seed makes the same ends")
    given = parser.parse_args()
    seed = given.seed or secrets.token_hex(4)
    print(f"seed {seed}, {given.runs} runs", flush=True)
    folder = Path(tempfile.mkdtemp(prefix="zbot-ends-"))
    report = Report()
    with (
        clean_end(),
        reserved_domain() as domain,
        StallMeter() as stall,
        Processes(folder, domain) as processes,
    ):
        all_ends = list(ends(seed, given.runs))
        random_ends = RandomEnds(processes, report, stall)
        with report.until_interrupted():
            for first in range(0, len(all_ends), _PARALLEL):
                random_ends.run(all_ends[first : first + _PARALLEL])
        random_ends.check_outputs()
        report.note(f"from the signal to the end: {times(random_ends.took_s)}")
    again = f"python -m tests.torture.random_ends --seed {seed} --runs {given.runs}"
    return report.end(again, folder, stall)


if __name__ == "__main__":
    sys.exit(main())
