"""All long runs, one after the other: `python -m tests.torture.nightly --minutes 60`.

Each run has a share of the time. The report is one page, which is printed and written to a file.
The whole output of each run is beside it. The exit code is 1 if a run broke a promise.
"""

from __future__ import annotations

import argparse
import contextlib
import math
import platform
import re
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from tests.torture.processes import clean_end
from tests.torture.readers import READERS
from zbot.version import __version__

_JOBS = 2  #: readers that run at the same time
_MOST_PROMISES = 5  #: broken promises of a run that the page shows
_MOST_OVERTIME = 2.0  #: a run that takes this many times its share is interrupted
_END_S = 60.0  #: from Ctrl-C until an interrupted run is killed
_FIGURES = re.compile(r"counts: |times as slow|promises broken$|failures in |no class: ")
_BROKEN = re.compile(r"BROKEN: |^  input |^again: ")


@dataclass(frozen=True)
class Run:
    """Long run.

    Args:
        module: Its module in this package, or an empty name for the torture of the readers.
        share: Its part of the whole time.
        one_s: About how many seconds one round takes on an idle machine, or a minute of its option.
        words: Its options. `{rounds}` is a number of rounds, and `{minutes}` a number of minutes.
    """

    module: str
    share: float
    one_s: float
    words: str

    @property
    def name(self) -> str:
        return self.module or "readers"

    def command(self, seconds: float) -> list[str]:
        """Return the command of a run that takes about this long."""
        count = seconds / self.one_s
        words = self.words.format(rounds=math.ceil(count), minutes=f"{count:.3f}").split()
        module = f"tests.torture.{self.module}".rstrip(".")
        return [sys.executable, "-u", "-m", module, *words]


RUNS = (
    # The time is for each reader. A reader ends earlier if it has read all its inputs.
    Run("", 0.25, len(READERS) * 60 / _JOBS, f"-n 1000000 --jobs {_JOBS} --minutes {{minutes}}"),
    Run("chaos", 0.25, 60, "--minutes {minutes}"),
    Run("soak", 0.2, 60, "--minutes {minutes}"),
    Run("random_ends", 0.08, 0.4, "--runs {rounds}"),
    Run("meeting_point_holders", 0.08, 28, "--runs {rounds}"),
    Run("churn", 0.09, 0.08, "--runs {rounds} --starts {rounds}0"),
    Run("periods", 0.05, 21, "--rounds {rounds}"),
)


def run(one: Run, seconds: float, output: Path) -> list[str]:
    """Do a run. Return its lines of the report; the first line says whether it kept its promises.

    Args:
        one: The run.
        seconds: About how long it takes.
        output: The file for all that it prints.
    """
    begin = time.monotonic()
    with output.open("w", encoding="utf-8") as file:
        process = subprocess.Popen(one.command(seconds), stdout=file, stderr=subprocess.STDOUT)
        try:
            code = _wait(process, seconds)
        except BaseException:
            process.send_signal(signal.SIGINT)
            process.wait()
            raise
    lines = output.read_text(encoding="utf-8", errors="replace").splitlines()
    broken = [line.strip() for line in lines if _BROKEN.search(line)] if code == 1 else []
    result = {0: "kept all promises", 1: "BROKEN", 130: "interrupted"}.get(
        code, f"exit code {code}"
    )
    if code not in {0, 1, 130}:
        broken = lines[-_MOST_PROMISES:]
    figures = [line.strip() for line in lines if _FIGURES.search(line)]
    shown = [*broken[:_MOST_PROMISES], *broken[_MOST_PROMISES:][-1:]]
    head = f"{one.name}: {result}, {time.monotonic() - begin:.0f} s"
    return [head, *(f"    {line[:160]}" for line in [*figures[-3:], *shown])]


def _wait(process: subprocess.Popen[bytes], seconds: float) -> int:
    with contextlib.suppress(subprocess.TimeoutExpired):
        return process.wait(_MOST_OVERTIME * seconds + _END_S)
    process.send_signal(signal.SIGINT)
    with contextlib.suppress(subprocess.TimeoutExpired):
        return process.wait(_END_S)
    process.kill()
    return process.wait()


def main() -> int:
    parser = argparse.ArgumentParser(description="All long runs in one night.")
    parser.add_argument("--minutes", type=float, default=60, help="time of all runs together")
    parser.add_argument("--only", action="append", help="only this run (can be repeated)")
    given = parser.parse_args()
    chosen = [one for one in RUNS if not given.only or one.name in given.only]
    if not chosen:
        names = ", ".join(one.name for one in RUNS)
        parser.error(f"there is no run {given.only[0]}: choose one of {names}")
    folder = Path(tempfile.mkdtemp(prefix="zbot-nightly-"))
    title = f"zbot {__version__}, Python {platform.python_version()}, {given.minutes:g} minutes"
    page = [title, time.strftime("%Y-%m-%d %H:%M")]
    print("\n".join(page), flush=True)
    seconds = 60 * given.minutes / sum(one.share for one in chosen)
    with clean_end():
        for one in chosen:
            lines = run(one, seconds * one.share, folder / f"{one.name}.txt")
            print("\n".join(lines), flush=True)
            page += lines
    (folder / "report.txt").write_text("\n".join(page) + "\n", encoding="utf-8")
    print(f"outputs: {folder}")
    heads = [line for line in page[2:] if not line.startswith(" ")]
    return int(any("kept all promises" not in head for head in heads))


if __name__ == "__main__":
    sys.exit(main())
