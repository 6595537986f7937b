"""Options and output that all listings share, such as ros2's daemon options and JSON."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from zbot.graph.snapshot import NamesAndTypes


@dataclass(frozen=True)
class DaemonOptions:
    """Group of ros2's daemon options. Only `--use-sim-time` has an effect, on the verb's node."""

    spin_time: Annotated[
        float, typer.Option("--spin-time", hidden=True, help="Accepted; no effect")
    ] = 0.5
    use_sim_time: Annotated[
        bool, typer.Option("-s", "--use-sim-time", hidden=True, help="Follow /clock")
    ] = False
    no_daemon: Annotated[
        bool, typer.Option("--no-daemon", hidden=True, help="Accepted; no effect")
    ] = False


@dataclass(frozen=True)
class NodeSearch(DaemonOptions):
    """Group of options that say which nodes a verb asks, and how long it waits for them."""

    include_hidden: Annotated[
        bool, typer.Option("--include-hidden-nodes", help="Consider hidden nodes too")
    ] = False
    timeout: Annotated[float, typer.Option("--timeout", help="Seconds to wait for the node")] = 1.0


NO_DAEMON: Final = DaemonOptions()
VISIBLE_NODES: Final = NodeSearch()

AsJson = Annotated[bool, typer.Option("--json", help="Print JSON")]
ShowTypes = Annotated[bool, typer.Option("-t", "--show-types", help="Add the types")]


def new_app(text: str, *, has_verbs: bool = True) -> typer.Typer:
    """Return the typer app of a command. It does not use rich, because rich is slow to import."""
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


def print_names(names: Sequence[str], *, count: bool, as_json: bool) -> None:
    """Print names on separate lines or as JSON, or print only their number."""
    if count:
        print(len(names))
    elif as_json:
        print_json(names)
    else:
        for name in names:
            print(name)


def print_entries(
    entries: NamesAndTypes,
    facts: Callable[[str, list[str]], object],
    *,
    show_types: bool,
    count: bool,
    as_json: bool,
) -> None:
    """Print names as a listing, with their types if requested.

    Args:
        entries: Names and types.
        facts: Function that makes the JSON value for a name and its types.
        show_types: Print the types after each name.
        count: Print only the number of names.
        as_json: Print JSON.
    """
    if as_json and not count:
        print_json([facts(name, types) for name, types in entries])
        return
    lines = [f"{name} [{', '.join(types)}]" if show_types else name for name, types in entries]
    print_names(lines, count=count, as_json=False)
