"""The command of a noun, with the verbs that its module has."""

from __future__ import annotations

import copy
import importlib
from typing import TYPE_CHECKING, Any

import typer.main

from zbot_cli.input.option_groups import spread

if TYPE_CHECKING:
    from collections.abc import Sequence

_MODULES = {"class": "class_"}  # `class` is a word of Python's


def load(noun: str, words: Sequence[str] = ()) -> Any:
    """Return the command of a noun; only its own module is imported.

    Typer's commands belong to a copy of click that it hides: hence no better type.

    Args:
        noun: One of `zbot_cli.main.NOUNS`.
        words: What follows it. If a verb comes first, the others are left out: typer takes some
            milliseconds to make one.
    """
    app = importlib.import_module(f"zbot_cli.commands.{_MODULES.get(noun, noun)}").app
    has_verbs = len(app.registered_commands) > 1
    app = copy.copy(app)
    app.registered_commands = _wanted(app.registered_commands, words)
    for verb in app.registered_commands:
        verb.callback = spread(verb.callback)
    command: Any = typer.main.get_group(app) if has_verbs else typer.main.get_command(app)
    for verb in verbs(command).values():
        # A list of verbs is no prose: each is described in a phrase, without a full stop.
        verb.short_help = (verb.help or "").partition("\n")[0].rstrip(".")
    return command


def _wanted(registered: list[Any], words: Sequence[str]) -> list[Any]:
    first = next((word for word in words if not word.startswith("-")), None)
    if first is None or all(verb.name != first for verb in registered):
        return registered  # help is wanted, or a suggestion; or there is one, without a name
    return [verb for verb in registered if verb.name in words]


def verbs(command: Any) -> dict[str, Any]:
    """Return the verbs of a command by their names; none if it has none."""
    found: dict[str, Any] = getattr(command, "commands", {})
    return found
