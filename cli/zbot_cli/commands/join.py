"""`zbot join`: links this machine with a classroom or with another machine."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated

import typer

from zbot_cli.output.listing import new_app

app = new_app("Join a class or another machine", has_verbs=False)


@app.command()
def join(
    target: Annotated[
        str, typer.Argument(metavar="CODE|HOST[:PORT]", help="The teacher's code, or an address")
    ],
    name: Annotated[str | None, typer.Option("--name", help="Your name")] = None,
    number: Annotated[
        int | None, typer.Option("--number", help="Your number in the class, 1 to 232")
    ] = None,
    keystore: Annotated[
        Path | None, typer.Option("--keystore", help="Folder of this machine's certificate")
    ] = None,
) -> None:
    """Join a class or another machine that runs `zbot hub`."""
    from zbot.classroom import student  # noqa: PLC0415 - not needed by `--help`

    joined = student.join(target, name=name, number=number, keystore=keystore, ask_pin=_ask_pin)
    if joined.in_class:
        print(f'joined "{joined.class_name}": {joined.name}, you are number {joined.number}')
        print("restart nodes that are already running; `zbot leave` leaves the class")
    else:
        print(f"joined {joined.host}:{joined.port}; `zbot leave` leaves it")


def _ask_pin(class_name: str) -> str | None:
    """Return the PIN from `$ZBOT_PIN`, or else from a hidden prompt or a line of stdin."""
    given = os.environ.get("ZBOT_PIN")
    if given:
        return given.strip()
    if sys.stdin.isatty():
        from getpass import getpass  # noqa: PLC0415 - needed only here

        return getpass(f'PIN of "{class_name}": ').strip()
    return sys.stdin.readline().strip() or None
