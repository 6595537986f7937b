"""`zbot join`: take part in a class, or in what another machine has."""

from __future__ import annotations

from typing import Annotated

import typer

from zbot_cli.listing import new_app

app = new_app("Join a class, or another machine", has_verbs=False)


@app.callback(invoke_without_command=True)
def join(
    target: Annotated[
        str, typer.Argument(metavar="CODE|HOST[:PORT]", help="The teacher's code, or an address")
    ],
) -> None:
    """Join a class, or another machine that runs `zbot hub`."""
    from zbot.classroom import student  # noqa: PLC0415 - help is quick

    joined = student.join(target)
    print(f"joined {joined.host}:{joined.port}; `zbot leave` ends it")
