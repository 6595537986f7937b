"""Submissions: the programs that students have handed in."""

from __future__ import annotations

import re
from collections import Counter
from typing import TYPE_CHECKING, NamedTuple

from zbot.simulation.errors import SimulationError
from zbot.simulation.marking.program import is_launch_file

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

_MAIN, _MAIN_LAUNCH = "main.py", "main.launch.py"


class Submission(NamedTuple):
    """Program of one student."""

    name: str  #: name of the file or the folder that was handed in
    program: Path | None  #: the file to run
    problem: str = ""  #: why there is no file to run
    bag: str = ""  #: name of its bag, which no other submission has


def find_submissions(paths: Iterable[Path]) -> list[Submission]:
    """Return the programs that some paths mean.

    A path is a program `.py` or a launch file, or a folder with a submission in each file and each
    folder. The program in the folder of a student is its launch file, also in `launch/` as in a
    package, or else its `main.py` or its only file in Python.

    Raises:
        SimulationError: A path does not exist, or there is no program.
    """
    found: list[Submission] = []
    for path in paths:
        if path.is_file():
            found.append(Submission(path.name, path.absolute()))
        elif path.is_dir():
            entries = sorted(path.iterdir(), key=lambda entry: entry.name)
            found += filter(None, map(_submission, entries))
        else:
            raise SimulationError(f"there is no file or folder {path}")
    if not found:
        raise SimulationError("the folder has no programs: a program is a file .py")
    return _with_bags(found)


def _with_bags(submissions: Iterable[Submission]) -> list[Submission]:
    """Give each submission the name of its bag, which all file systems can have."""
    counts: Counter[str] = Counter()
    found = []
    for submission in submissions:
        name = re.sub(r"[^\w.-]+", "_", submission.name.removesuffix(".py"))[:100]
        counts[name.lower()] += 1
        number = counts[name.lower()]
        found.append(submission._replace(bag=name if number == 1 else f"{name}-{number}"))
    return found


def _submission(entry: Path) -> Submission | None:
    """Return the submission in a file or a folder, or None if it is something else."""
    if entry.name.startswith((".", "__")):
        return None
    if entry.is_file():
        is_program = entry.suffix == ".py" or is_launch_file(entry)
        return Submission(entry.name, entry.absolute()) if is_program else None
    files = sorted([*entry.glob("*"), *entry.glob("launch/*")])
    launched = [file for file in files if is_launch_file(file)]
    if launched:
        return _only(entry, launched, _MAIN_LAUNCH, "launch files")
    if (entry / "package.xml").is_file():
        return Submission(entry.name, None, "the package has no launch file")
    programs = sorted(entry.glob("*.py"))
    if not programs:
        return Submission(entry.name, None, "the folder has no program .py")
    return _only(entry, programs, _MAIN, "programs")


def _only(entry: Path, files: list[Path], main: str, what: str) -> Submission:
    """Return the only one of some files, or that with the name of the main one."""
    named = [file for file in files if file.name == main] or files
    if len(named) == 1:
        return Submission(entry.name, named[0].absolute())
    return Submission(entry.name, None, f"the folder has {len(files)} {what}, and none is {main}")
