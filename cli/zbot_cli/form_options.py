"""How messages are to be printed, on the command line of everything that echoes them."""

from __future__ import annotations

from typing import Annotated

import typer

Csv = Annotated[bool, typer.Option("--csv", help="Print fields separated by commas")]
FullLength = Annotated[bool, typer.Option("-f", "--full-length", help="Show everything")]
TruncateLength = Annotated[
    int, typer.Option("-l", "--truncate-length", help="Elements and characters to show")
]
NoArr = Annotated[bool, typer.Option("--no-arr", help="Leave out the content of arrays")]
NoStr = Annotated[bool, typer.Option("--no-str", help="Leave out the content of strings")]
FlowStyle = Annotated[bool, typer.Option("--flow-style", help="Print collections on one line")]
