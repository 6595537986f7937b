"""Names of students, classes and laptops that other machines send, safe to print."""

from __future__ import annotations

from zbot.terminal.text import single_line

MAX_NAME_LENGTH = 64


def clean_name(text: str) -> str:
    """Return a name that is safe to print: one line of at most 64 printable characters.

    Control characters and characters that change the direction of writing become spaces.
    """
    return single_line(text, MAX_NAME_LENGTH)
