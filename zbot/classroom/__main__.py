"""Hub in the background. `zbot join` and `zbot class start` run `python -m zbot.classroom ROLE`.

The hub reads its settings and secrets from files that only its user can read. The command line
contains only the role.
"""

from __future__ import annotations

import sys

from zbot.classroom.errors import not_joined_error
from zbot.classroom.hub import running_hub
from zbot.classroom.student.laptop_hub import run_student
from zbot.classroom.teacher.opening import run_teacher
from zbot.transport import membership


def main() -> int:
    """Run the hub of this machine's role (teacher or student), and return the exit code."""
    return running_hub.exit_code(_run)


def _run() -> None:
    joined = membership.load()
    if joined is None:
        raise not_joined_error()
    run = run_teacher if joined.role == "teacher" else run_student
    run(joined, running_hub.report_ready)


if __name__ == "__main__":
    sys.exit(main())
