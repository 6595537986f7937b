"""`zbot leave`: ends the link that `zbot join` made."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated

import typer

from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app

if TYPE_CHECKING:
    from zbot.classroom.student.joining import Left
    from zbot.transport.membership import Membership

app = new_app("Leave the class or the other machine", has_verbs=False)


@app.command()
def leave(
    yes: Annotated[
        bool, typer.Option("--yes", "-y", help="Close the teacher's class without a question")
    ] = False,
) -> None:
    """Leave the class or the other machine."""
    from zbot.classroom.errors import not_joined_error  # noqa: PLC0415 - not needed by `--help`
    from zbot_cli.domain.client import print_programs_outside  # noqa: PLC0415 - as above

    if not (yes or _may_close()):
        print("the class stays open")
        raise typer.Exit(Status.ERROR)
    left = _leave()
    if left is None:
        raise not_joined_error()
    former = left.membership
    print(f"left {former.class_name or former.host}")
    if not left.is_released:
        print(
            f"the class does not answer, so it may keep number {former.number} for this laptop: "
            f"the teacher can free it with `zbot class free {former.number}`",
            file=sys.stderr,
        )
    print_programs_outside()


def _leave() -> Left | None:
    """Leave the class or the other machine. On the teacher's machine, close the class."""
    from zbot.classroom.student import joining  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher import opening  # noqa: PLC0415 - as above

    if _own_class() is None:
        return joining.leave()
    return joining.Left(opening.stop(), is_released=True)


def _own_class() -> Membership | None:
    """Return the membership of a teacher's machine, or `None` on any other machine."""
    from zbot.transport import membership  # noqa: PLC0415 - not needed by `--help`

    try:
        present = membership.load()
    except membership.MembershipError:
        return None  # leaving removes the damaged file
    return present if present is not None and present.role == "teacher" else None


def _may_close() -> bool:
    """Ask before a class on this machine is closed. Return True if the command may go on."""
    from zbot.classroom.errors import ClassroomError  # noqa: PLC0415 - not needed by `--help`

    present = _own_class()
    if present is None:
        return True
    if not sys.stdin.isatty():
        raise ClassroomError(
            f'leaving closes the class "{present.class_name}" for all students: '
            "type `zbot class stop`, or `zbot leave --yes`"
        )
    return typer.confirm(
        f'This closes the class "{present.class_name}" for all students. Close it?'
    )
