"""Functions that make text from other programs safe to print on a terminal."""

from __future__ import annotations


def single_line(text: str, longest: int) -> str:
    """Return a text in one line, without control or direction characters.

    Every character that is not printable becomes a space. Several spaces become one space.

    Args:
        text: Text from any source.
        longest: Maximum number of characters in the result.
    """
    shown = "".join(char if char.isprintable() else " " for char in text)
    return " ".join(shown.split())[:longest].rstrip()


def escape_control_characters(text: str) -> str:
    r"""Return a text with its control characters written as escapes, e.g. `\x1b`.

    Line ends and tabs are kept.
    """
    return "".join(char if char.isprintable() or char in "\n\t" else _shown(char) for char in text)


def _shown(char: str) -> str:
    return repr(char)[1:-1]
