"""Verbs of `zbot class`: start a classroom, list and check its students, and stop it."""

from __future__ import annotations

import os
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from zbot_cli.output.exit_status import Status
from zbot_cli.output.listing import AsJson, new_app, print_json

if TYPE_CHECKING:
    from zbot.classroom.class_record import ClassRecord
    from zbot.transport.membership import Membership

app = new_app("Start and manage a class")


@app.callback()
def options() -> None:
    """Start and manage a class."""


@app.command("start")
def start(
    name: Annotated[str, typer.Argument(help="Name of the class")] = "class",
    pin: Annotated[
        bool, typer.Option("--pin", help="Make a PIN, which students must enter")
    ] = False,
    port: Annotated[
        int | None, typer.Option("--port", min=1, max=65535, help="TCP port; 7447 by default")
    ] = None,
    students: Annotated[
        Path | None, typer.Option("--students", help="File with NUMBER,NAME in each line")
    ] = None,
    keystore: Annotated[
        Path | None, typer.Option("--keystore", help="Folder of this machine's certificate")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Start a class."""
    from zbot.classroom import teacher  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.register import clean_name, load_roster  # noqa: PLC0415 - as above
    from zbot.security.pin import random_pin  # noqa: PLC0415 - as above
    from zbot.transport.config import hub_port  # noqa: PLC0415 - as above

    expected = load_roster(students) if students else None
    chosen = (os.environ.get("ZBOT_PIN") or random_pin().reveal()) if pin else ""
    opened, record = teacher.start(
        clean_name(name), port or hub_port(), pin=chosen, expected=expected, keystore=keystore
    )
    facts = _join_facts(opened, record)
    print_json(facts) if as_json else print(_join_text(facts))


def _join_facts(opened: Membership, record: ClassRecord) -> dict[str, object]:
    """Return the facts that students use to join: codes, address and PIN."""
    from zbot.classroom.join_code import long_code, short_code  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher import address_of  # noqa: PLC0415 - as above

    address = address_of(opened)
    return {
        "class": opened.class_name,
        "code": short_code(address) or long_code(address),
        "long_code": long_code(address),
        "host": address.host,
        "port": address.port,
        "pin": record.pin or None,
    }


def _join_text(facts: dict[str, object]) -> str:
    lines = [f'Class "{facts["class"]}" is open. Students type:', ""]
    if facts["code"]:
        lines.append(f"    zbot join {facts['code']}")
    lines += [f"    zbot join {facts['host']}:{facts['port']}    (if the code does not work)", ""]
    if facts["pin"]:
        lines.append(f"PIN: {facts['pin']}")
    return "\n".join([*lines, "`zbot class list` lists students, `zbot class stop` ends the class"])


@app.command("list")
def list_students(as_json: AsJson = False) -> None:
    """List the students and their machines."""
    from zbot.classroom.teacher import command  # noqa: PLC0415 - not needed by `--help`

    found = command({"op": "list"})
    if as_json:
        print_json(found)
        return
    from zbot_cli.commands.class_.table import table  # noqa: PLC0415 - not needed by `--help`

    print(table(found))


@app.command("check")
def check(
    expected: Annotated[
        str, typer.Argument(help='Such as "publishes std_msgs/String on /student_id at >= 1 Hz"')
    ],
    as_json: AsJson = False,
) -> None:
    """Check the programs of all students."""
    from zbot.classroom.expectation import parse_expectations  # noqa: PLC0415 - not needed by `--help`
    from zbot.classroom.teacher import check_class  # noqa: PLC0415 - as above

    verdicts = check_class(parse_expectations(expected))
    passed = sum(verdict.passes for verdict in verdicts)
    if as_json:
        print_json([{**asdict(one), "passes": one.passes} for one in verdicts])
    else:
        for one in verdicts:
            mark = "ok  " if one.passes else "FAIL"
            print(f"{mark}  {one.number:3}  {one.name}  {'; '.join(one.problems)}".rstrip())
        print(f"{passed} of {len(verdicts)} pass")
    if passed < len(verdicts):
        raise typer.Exit(Status.ERROR)


@app.command("say")
def say(text: Annotated[list[str], typer.Argument(help="Text of the message")]) -> None:
    """Send a message to all students."""
    from zbot.classroom.teacher import command  # noqa: PLC0415 - not needed by `--help`

    heard = command({"op": "say", "text": " ".join(text)})["heard"]
    print(f"sent to {heard} student{'' if heard == 1 else 's'}")


@app.command("free")
def free(
    number: Annotated[int, typer.Argument(min=1, max=232, help="Number of a student")],
) -> None:
    """Free the number of a laptop that left."""
    from zbot.classroom.teacher import command  # noqa: PLC0415 - not needed by `--help`

    print(f"number {number} is free; {command({'op': 'free', 'number': number})['name']} had it")


@app.command("stop")
def stop() -> None:
    """Stop the class."""
    from zbot.classroom import teacher  # noqa: PLC0415 - not needed by `--help`

    print(f'Class "{teacher.stop().class_name}" is closed')
