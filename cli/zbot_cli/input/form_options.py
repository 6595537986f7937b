"""How messages are to be printed, on the command line of everything that echoes them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

if TYPE_CHECKING:
    from zbot_cli.output.message_text import Form


@dataclass(frozen=True)
class FormOptions:
    """What the options said; each field is one."""

    csv: Annotated[bool, typer.Option("--csv", help="Print fields separated by commas")] = False
    full_length: Annotated[bool, typer.Option("-f", "--full-length", help="Show everything")] = (
        False
    )
    truncate_length: Annotated[
        int, typer.Option("-l", "--truncate-length", help="Elements and characters to show")
    ] = 128
    no_arr: Annotated[bool, typer.Option("--no-arr", help="Leave out the content of arrays")] = (
        False
    )
    no_str: Annotated[bool, typer.Option("--no-str", help="Leave out the content of strings")] = (
        False
    )
    flow_style: Annotated[
        bool, typer.Option("--flow-style", help="Print collections on one line")
    ] = False

    def form(self, *, as_json: bool, **more: Any) -> Form:
        """Return the form of the messages; `more` are fields of it that not every verb has."""
        from zbot_cli.output.message_text import Form  # noqa: PLC0415 - lists do without

        return Form(
            csv=self.csv,
            length=None if self.full_length else self.truncate_length,
            no_arr=self.no_arr,
            no_str=self.no_str,
            flow_style=self.flow_style,
            json=as_json,
            **more,
        )


DEFAULT_FORM: Final = FormOptions()
