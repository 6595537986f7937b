"""The command of a noun, with the verbs that its module has."""

from __future__ import annotations

import importlib
from typing import Any

import typer.main

# `class` is a word of Python's, exit codes are in `status`, and pytest looks into `test_*`.
_MODULES = {"class": "class_", "status": "status_", "test": "launch_test"}


def load(noun: str) -> Any:
    """Return the command of a noun; only its own module is imported.

    Typer's commands belong to a copy of click that it hides: hence no better type.
    """
    module = importlib.import_module(f"zbot_cli.{_MODULES.get(noun, noun)}")
    command: Any = typer.main.get_command(module.app)
    for verb in verbs(command).values():
        # A list of verbs is no prose: each is described in a phrase, without a full stop.
        verb.short_help = (verb.help or "").partition("\n")[0].rstrip(".")
    return command


def verbs(command: Any) -> dict[str, Any]:
    """Return the verbs of a command by their names; none if it has none."""
    found: dict[str, Any] = getattr(command, "commands", {})
    return found
