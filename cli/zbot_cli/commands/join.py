"""`zbot join`: links this machine with a classroom or with another machine."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import new_app

if TYPE_CHECKING:
    from zbot.transport.membership import Membership

app = new_app("Join a class or another machine", has_verbs=False)


@app.command()
def join(
    target: Annotated[
        str | None,
        typer.Argument(
            metavar="CODE|HOST[:PORT]",
            help="The teacher's code, or an address; leave it out to continue after a restart",
        ),
    ] = None,
    name: Annotated[str | None, typer.Option("--name", help="Your name")] = None,
    number: Annotated[
        int | None, typer.Option("--number", help="Your number in the class, 1 to 232")
    ] = None,
    new_student: Annotated[
        bool, typer.Option("--new-student", help="You are not in the teacher's list of students")
    ] = False,
    keystore: Annotated[
        Path | None, typer.Option("--keystore", help="Folder of this machine's certificate")
    ] = None,
) -> None:
    """Join a class or another machine that runs `zbot hub`.

    Without a code or an address, start the hub of this machine again, e.g. after a restart.
    """
    from zbot.classroom.student import joining  # noqa: PLC0415 - not needed by `--help`
    from zbot_cli.commands.status import namesakes_text  # noqa: PLC0415 - as above
    from zbot_cli.domain.client import print_programs_outside  # noqa: PLC0415 - as above

    if target is None:
        if name or number or new_student or keystore:
            raise typer.BadParameter("type the teacher's code, or an address, before the options")
        _resume()
        return
    joined, namesakes = joining.join(
        target,
        name=name,
        number=number,
        is_new=new_student,
        keystore=keystore,
        ask_pin=_ask_pin,
        ask_name=_ask_name,
    )
    if joined.in_class:
        print(f'joined "{joined.class_name}": {joined.name}, you are number {joined.number}')
        print("`zbot leave` leaves the class")
    else:
        print(f"joined {joined.host}:{joined.port}; `zbot leave` leaves it")
    if namesakes:
        print(namesakes_text(joined.name, namesakes), file=sys.stderr)
    _print_version(joined)
    _print_differences()
    print_programs_outside()


def _print_version(joined: Membership) -> None:
    """Print a line if the class or hub has another version of zbot than this machine."""
    from zbot.transport.other_version import other_versions_text  # noqa: PLC0415 - not needed by `--help`

    who = f'the class "{joined.class_name}"' if joined.in_class else joined.host
    text = other_versions_text({who: joined.version})
    if text:
        print(text, file=sys.stderr)


def _resume() -> None:
    """Start the hub of this machine again, and print what `zbot status` prints."""
    from zbot.classroom.machine_state import present_state  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.student import joining  # noqa: PLC0415 - as above
    from zbot_cli.commands.status import lines  # noqa: PLC0415 - as above

    joining.resume()
    state = present_state()
    print("\n".join(lines(state)))
    if not state["linked"]:
        raise typer.Exit(Status.ERROR)


def _print_differences() -> None:
    """Print the settings of this machine that differ from the class or hub that was joined."""
    from zbot.errors import ZbotError  # noqa: PLC0415 - not needed by `--help`
    from zbot.transport import environment  # noqa: PLC0415 - as above

    try:
        for difference in environment.differences():
            print(difference.text, file=sys.stderr)
    except ZbotError as error:  # an environment variable or a configuration file is not valid
        print(error, file=sys.stderr)


def _ask_pin(class_name: str) -> str | None:
    """Return the PIN from `$ZBOT_PIN`, or else from a hidden prompt or a line of stdin."""
    given = os.environ.get("ZBOT_PIN")
    if given:
        return given.strip()
    if sys.stdin.isatty():
        from getpass import getpass  # noqa: PLC0415 - needed only here

        return getpass(f'PIN of "{class_name}": ').strip()
    return sys.stdin.readline().strip() or None


def _ask_name(given: str, known: str) -> bool | None:
    """Ask whether the student is `known`. Without a terminal, return `None`.

    Args:
        given: The name that the student typed.
        known: A similar name in the teacher's list.
    """
    if not sys.stdin.isatty():
        return None
    return typer.confirm(f'The teacher\'s list has no "{given}", but "{known}". Are you {known}?')
