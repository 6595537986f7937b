"""Commands of the nouns. In `zbot topic list`, the noun is `topic`, and its verb is `list`."""

from __future__ import annotations

import copy
import importlib
from typing import TYPE_CHECKING, Any

import typer.main

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Modules that cannot have the names of their nouns: `class` is a keyword, and `-` is not allowed.
_MODULES = {"class": "class_", "setup-shell": "setup_shell"}


def load(noun: str, words: Sequence[str] = ()) -> Any:
    """Return the command of a noun. Import only the noun's module.

    The result is a click command. Its type is `Any` because typer contains a private copy of click.

    Args:
        noun: One of `zbot_cli.main.NOUNS`.
        words: The words after the noun. If the first word is a verb, the command gets only this
            verb, because typer needs some milliseconds for each verb.
    """
    app = importlib.import_module(f"zbot_cli.commands.{_MODULES.get(noun, noun)}").app
    has_verbs = len(app.registered_commands) > 1
    app = copy.copy(app)
    app.registered_commands = _wanted(app.registered_commands, words)
    command: Any = typer.main.get_group(app) if has_verbs else typer.main.get_command(app)
    found = verbs(command)
    for verb in found.values():
        # `--help` lists each verb with the first line of its help, without the full stop.
        verb.short_help = (verb.help or "").partition("\n")[0].rstrip(".")
    if not {"-h", "--help"}.isdisjoint(words):
        from zbot_cli.output.examples import epilog  # noqa: PLC0415 - needed only for help

        for name, child in (found or {"": command}).items():
            child.epilog = epilog(f"{noun} {name}".strip())
    return command


def _wanted(registered: list[Any], words: Sequence[str]) -> list[Any]:
    first = next((word for word in words if not word.startswith("-")), None)
    if first is None or all(verb.name != first for verb in registered):
        return registered  # for help or a suggestion, or because the noun has no verbs
    return [verb for verb in registered if verb.name in words]


def verbs(command: Any) -> dict[str, Any]:
    """Return the verbs of a command by name, or an empty dictionary if it has no verbs."""
    found: dict[str, Any] = getattr(command, "commands", {})
    return found
