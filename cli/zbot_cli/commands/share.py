"""`zbot share`: open one student's domain to another, or the shared space to everybody."""

from __future__ import annotations

from typing import Annotated

import typer

from zbot_cli.output.listing import new_app

app = new_app("Let a student see another's topics", has_verbs=False)


@app.command()
def share(
    owner: Annotated[
        str, typer.Argument(metavar="NUMBER|class", help="Whose topics; class: the shared space")
    ],
    reader: Annotated[
        int | None, typer.Argument(min=1, max=232, help="Number of the student who may see them")
    ] = None,
    stop: Annotated[bool, typer.Option("--stop", help="Take it back")] = False,
) -> None:
    """Let a student see another's topics, or everybody publish in /class/."""
    from zbot.classroom.teacher import command  # noqa: PLC0415 - help is quick

    if owner == "class":
        command({"op": "open", "on": not stop})
        print("only the teacher publishes in /class/" if stop else "everybody publishes in /class/")
        return
    if not (owner.isascii() and owner.isdigit()) or reader is None:
        raise typer.BadParameter("say whose topics who may see: zbot share 17 18")
    command({"op": "share", "owner": int(owner), "reader": reader, "on": not stop})
    word = "no longer sees" if stop else "sees"
    print(f"{reader} {word} the topics of {owner}, as /{owner}/...")
