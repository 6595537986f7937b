"""`zbot leave`: ends the link that `zbot join` made."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app

app = new_app("Leave the class or the other machine", has_verbs=False)


@app.command()
def leave(
    yes: Annotated[
        bool, typer.Option("--yes", "-y", help="Close the teacher's class without a question")
    ] = False,
) -> None:
    """Leave the class or the other machine."""
    from zbot.classroom.errors import NotJoinedError  # noqa: PLC0415 - as above
    from zbot.classroom.student import joining  # noqa: PLC0415 - not needed by `--help`
    from zbot_cli.domain.client import print_programs_outside  # noqa: PLC0415 - as above

    if not (yes or _may_close()):
        print("the class stays open")
        raise typer.Exit(Status.ERROR)
    left = joining.leave()
    if left is None:
        raise NotJoinedError
    former = left.membership
    print(f"left {former.class_name or former.host}")
    if not left.is_released:
        print(
            f"the class does not answer, so it may keep number {former.number} for this laptop: "
            f"the teacher can free it with `zbot class free {former.number}`",
            file=sys.stderr,
        )
    print_programs_outside()


def _may_close() -> bool:
    """Ask before a class on this machine is closed. Return True if the command may go on."""
    from zbot.classroom.errors import ConfirmationError  # noqa: PLC0415 - not needed by `--help`
    from zbot.transport import membership  # noqa: PLC0415 - as above

    try:
        present = membership.load()
    except membership.MembershipError:
        return True  # leaving removes the damaged file
    if present is None or present.role != "teacher":
        return True
    if not sys.stdin.isatty():
        raise ConfirmationError(present.class_name)
    return typer.confirm(
        f'This closes the class "{present.class_name}" for all students. Close it?'
    )
