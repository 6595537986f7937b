"""`python -m zbot.classroom ROLE`: the hub that `zbot join` and `zbot class start` leave running.

What it needs to know, secrets too, is in files that only its user can read, never on its command
line.
"""

from __future__ import annotations

import sys

from zbot.classroom import background
from zbot.classroom.errors import NotJoinedError
from zbot.classroom.student import run_student
from zbot.classroom.teacher import run_teacher
from zbot.errors import ZbotError
from zbot.transport import membership


def main() -> int:
    """Run the hub of the role that this machine has joined in."""
    try:
        joined = membership.load()
        if joined is None:
            raise NotJoinedError
        run = run_teacher if joined.role == "teacher" else run_student
        run(joined, background.say_ready)
    except ZbotError as error:
        print(error, flush=True)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
