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


def harmless(text: str) -> str:
    """Return a text of several lines whose control characters are shown rather than obeyed.

    Line ends and tabs stay what they are.

    Args:
        text: From anywhere.
    """
    return "".join(char if char.isprintable() or char in "\n\t" else _shown(char) for char in text)


def _shown(char: str) -> str:
    return repr(char)[1:-1]
