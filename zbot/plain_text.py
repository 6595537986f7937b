"""Text of strangers, as it may be shown on a terminal."""

from __future__ import annotations


def plain(text: str, longest: int) -> str:
    """Return a text in one line, without anything that moves a cursor or turns the writing round.

    Control characters and the like become spaces; of several spaces one remains.

    Args:
        text: From anywhere.
        longest: How many characters remain at most.
    """
    shown = "".join(char if char.isprintable() else " " for char in text)
    return " ".join(shown.split())[:longest].rstrip()
