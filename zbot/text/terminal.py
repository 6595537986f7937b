"""Functions that make text from other programs safe to print on a terminal."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Final, TextIO

if TYPE_CHECKING:
    from collections.abc import Iterable

_COLOUR: Final = re.compile(r"(\x1b\[[0-9;:]*m)")


def single_line(text: str, longest: int) -> str:
    """Return a text in one line, without characters that control the terminal or text direction.

    Every character that is not printable becomes a space. Several spaces become one space.

    Args:
        text: Text from any source.
        longest: Maximum number of characters in the result.
    """
    shown = "".join(char if char.isprintable() else " " for char in text)
    return " ".join(shown.split())[:longest].rstrip()


def escape_control_characters(text: str, *, keep_colours: bool = False) -> str:
    r"""Return a text with its control characters written as escapes, e.g. `\x1b`.

    Line ends and tabs are kept.

    Args:
        text: Text from any source.
        keep_colours: Keep sequences that change only the colour and style of the text.
    """
    if text.replace("\n", "").replace("\t", "").isprintable():
        return text
    if keep_colours:
        parts = _COLOUR.split(text)  # texts have even indexes, colours odd ones
        parts[::2] = map(escape_control_characters, parts[::2])
        return "".join(parts)
    return "".join(char if char.isprintable() or char in "\n\t" else _shown(char) for char in text)


def _shown(char: str) -> str:
    return repr(char)[1:-1]


class TerminalStream:
    """Text stream of a terminal that writes control characters as escapes.

    It can replace `sys.stdout` and `sys.stderr`. Everything except writing works as for the
    original stream. zbot writes its own control characters with `write_styled`.

    Args:
        stream: The original stream.
    """

    def __init__(self, stream: TextIO) -> None:
        self.stream = stream  #: the original stream

    def write(self, text: str) -> int:
        """Write a text. Write its control characters as escapes."""
        self.stream.write(escape_control_characters(text))
        return len(text)

    def writelines(self, lines: Iterable[str]) -> None:
        """Write several texts. Write their control characters as escapes."""
        for line in lines:
            self.write(line)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


def write_styled(stream: TextIO | TerminalStream, text: str) -> None:
    """Write a text with zbot's own control characters, also to a `TerminalStream`.

    The caller must escape all parts of the text that come from other programs.
    """
    original = stream.stream if isinstance(stream, TerminalStream) else stream
    original.write(text)
