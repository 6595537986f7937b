"""Check of programs that drive a robot in a simulated world, without a running class."""

from __future__ import annotations

import csv
import os
import sys
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from zbot.bag.packages import import_mcap
from zbot.classroom.teacher.class_check import Verdict
from zbot.process.signals import ending_process
from zbot.simulation.engine import engine
from zbot.testing.domain import reserved_domain
from zbot_cli.errors import CommandError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from zbot.simulation.marking.submissions import Submission
    from zbot.simulation.marking.trial import Course, Mark

#: Settings that keep a check apart from a class and from other machines.
_APART = {"ZBOT_DISCOVERY_RANGE": "localhost", "ZBOT_HUB_PORT": "9"}


def check_programs(
    task: str,
    programs: Sequence[Path],
    *,
    world: str,
    robot: str,
    seed: int,
    output: Path | None,
    tell: Callable[[Verdict], None],
) -> list[Verdict]:
    """Return a verdict for each program.

    Args:
        task: What the programs have to do.
        programs: Programs, or folders with programs.
        world: The world.
        robot: The robot.
        seed: The seed of the noise.
        output: The folder of the bags. `None` means a folder with the date.
        tell: Called with each verdict, as soon as it is known.

    Raises:
        SimulationError: The world, the robot or a program does not exist.
        ClassValueError: The task has a part that is not known.
        CommandError: The folder exists.
        NoBagExtraError: The extra `bag` is not installed.
        MissingPackageError: The extra `sim` is not installed.
    """
    with ending_process():
        engine()  # the other modules need numpy, which the extra brings
        import_mcap()
        from zbot.simulation.marking.submissions import find_submissions  # noqa: PLC0415 - see above
        from zbot.simulation.marking.trial import Course, check_course  # noqa: PLC0415 - as above
        from zbot.simulation.node.program import Options  # noqa: PLC0415 - as above

    found = find_submissions(programs)
    folder = output or Path(f"{datetime.now():marks_%Y_%m_%d-%H_%M_%S}")
    with _domain() as domain:
        course = Course(task, Options(world, (robot,), seed=seed), domain)
        check_course(course)
        try:
            folder.mkdir(parents=True)
        except FileExistsError:
            raise CommandError(f"the folder {folder} exists: choose another one with -o") from None
        verdicts = [_verdict(submission, course, folder, tell) for submission in found]
    _write_table(folder / "marks.csv", verdicts)
    print(f"The bags and the output of the programs are in {folder}", file=sys.stderr)
    return verdicts


@contextmanager
def _domain() -> Iterator[int]:
    """Reserve a domain, and keep it apart from other machines."""
    before = {name: os.environ.get(name) for name in _APART}
    os.environ.update(_APART)
    try:
        with reserved_domain() as domain:
            yield domain
    finally:
        for name, value in before.items():
            os.environ.pop(name, None)
            if value is not None:
                os.environ[name] = value


def _verdict(
    submission: Submission, course: Course, folder: Path, tell: Callable[[Verdict], None]
) -> Verdict:
    if submission.program is None:
        verdict = Verdict(0, submission.name, (submission.problem,))
    else:
        mark = _mark(submission.program, course, folder / submission.bag)
        verdict = Verdict(0, submission.name, mark.problems)
    tell(verdict)
    return verdict


def _mark(program: Path, course: Course, bag: Path) -> Mark:
    from zbot.simulation.marking.trial import Trial  # noqa: PLC0415 - needs the extra

    trial = Trial(course, program, bag)
    mark = trial.run()
    bag.with_name(f"{bag.name}.txt").write_text(trial.output, "utf-8", "replace")
    return mark


def _write_table(path: Path, verdicts: Sequence[Verdict]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        table.writerow(["name", "passes", "problems"])
        for verdict in verdicts:
            table.writerow([verdict.name, verdict.passes, "; ".join(verdict.problems)])
