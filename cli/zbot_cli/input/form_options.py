"""Options for the form in which commands such as `zbot topic echo` print messages."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

if TYPE_CHECKING:
    from zbot_cli.output.message_text import Form


@dataclass(frozen=True)
class FormOptions:
    """Group of options for the form of messages."""

    csv: Annotated[bool, typer.Option("--csv", help="Print fields separated by commas")] = False
    full_length: Annotated[bool, typer.Option("-f", "--full-length", help="Shorten nothing")] = (
        False
    )
    truncate_length: Annotated[
        int, typer.Option("-l", "--truncate-length", help="Maximum length of arrays and strings")
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
        """Return the form of messages. `more` holds the fields of `Form` that this group lacks."""
        from zbot_cli.output.message_text import Form  # noqa: PLC0415 - not needed by `list`

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
