"""What every listing shares: options of ros2 that need nothing here, and output as JSON."""

from __future__ import annotations

import json
from typing import Annotated, Any

import typer

# ros2 asks these of its daemon; there is none here, so they are accepted and change nothing.
SpinTime = Annotated[float, typer.Option("--spin-time", hidden=True, help="Accepted; not needed")]
UseSimTime = Annotated[bool, typer.Option("-s", "--use-sim-time", hidden=True, help="Accepted")]
NoDaemon = Annotated[bool, typer.Option("--no-daemon", hidden=True, help="Accepted; there is none")]

AsJson = Annotated[bool, typer.Option("--json", help="Print JSON instead")]
ShowTypes = Annotated[bool, typer.Option("-t", "--show-types", help="Add the types")]


def new_app(text: str, *, has_verbs: bool = True) -> typer.Typer:
    """Return the app of a noun: plain help (rich takes longer to import than most verbs take)."""
    return typer.Typer(
        help=text,
        no_args_is_help=has_verbs,
        add_completion=False,
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )


def print_json(value: Any) -> None:
    """Print one JSON document on one line."""
    print(json.dumps(value, ensure_ascii=False))
