"""`zbot share`: lets a student read another student's topics, or lets all publish in /class/."""

from __future__ import annotations

from typing import Annotated

import typer

from zbot.text.whole_number import whole_number
from zbot_cli.output.listing import new_app

app = new_app("Let one student read another's topics", has_verbs=False)


@app.command()
def share(
    owner: Annotated[
        str,
        typer.Argument(
            metavar="NUMBER|class", help="Number of the student whose topics to share, or `class`"
        ),
    ],
    reader: Annotated[
        int | None, typer.Argument(min=1, max=232, help="Number of the student who may read them")
    ] = None,
    stop: Annotated[bool, typer.Option("--stop", help="Undo an earlier `zbot share`")] = False,
) -> None:
    """Let one student read another's topics, or let everybody publish in /class/."""
    from zbot.classroom.teacher.opening import command  # noqa: PLC0415 - not needed by `--help`

    if owner == "class":
        command({"op": "open", "on": not stop})
        print(f"{'only the teacher' if stop else 'everybody'} can publish in /class/")
        return
    number = whole_number(owner, 8)
    if number is None or reader is None:
        raise typer.BadParameter("name the owner and the reader of the topics: zbot share 17 18")
    command({"op": "share", "owner": number, "reader": reader, "on": not stop})
    word = "no longer sees" if stop else "sees"
    print(f"{reader} {word} the topics of {owner}, as /{owner}/...")
