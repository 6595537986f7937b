"""`zbot class`: open a class, see who is there, and look after it."""

from __future__ import annotations

from typing import Annotated

import typer

from zbot_cli.listing import AsJson, new_app, print_json

app = new_app("Open a class, and look after it")


@app.callback()
def options() -> None:
    """Open a class, and look after it."""


@app.command("start")
def start(
    name: Annotated[str, typer.Argument(help="What the class is called")] = "class",
    port: Annotated[
        int | None, typer.Option("--port", min=1, max=65535, help="TCP port; 7447 by default")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Open a class."""
    from zbot.classroom import teacher  # noqa: PLC0415 - help is quick
    from zbot.classroom.address import Address  # noqa: PLC0415 - as above
    from zbot.classroom.join_code import long_code, short_code  # noqa: PLC0415 - as above
    from zbot.config import hub_port  # noqa: PLC0415 - as above

    opened = teacher.start(name, port or hub_port())
    address = Address(opened.host, opened.port)
    if as_json:
        codes = {"code": short_code(address), "long_code": long_code(address)}
        print_json({"class": opened.class_name, "address": str(address), **codes})
        return
    code = short_code(address) or long_code(address)
    print(f'Class "{opened.class_name}" is open. Students type:')
    if code:
        print(f"    zbot join {code}")
    print(f"    zbot join {address}")


@app.command("stop")
def stop() -> None:
    """Close the class."""
    from zbot.classroom import teacher  # noqa: PLC0415 - help is quick

    print(f'Class "{teacher.stop().class_name}" is closed')
