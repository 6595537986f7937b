from __future__ import annotations

import io
from typing import TextIO, cast

import pytest

from zbot.text.terminal import (
    TerminalStream,
    escape_control_characters,
    single_line,
    write_styled,
)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("temperature: 3.5\n\tok", "temperature: 3.5\n\tok"),
        ("Größe 大小 🐢", "Größe 大小 🐢"),
        ("\x1b[2Jgone", "\\x1b[2Jgone"),
        ("\x1b]0;title\x07", "\\x1b]0;title\\x07"),
        ("a\rb", "a\\rb"),
        ("\u202egnp.exe", "\\u202egnp.exe"),
        ("\x9b31m", "\\x9b31m"),
    ],
)
def test_control_characters_are_escaped(text: str, shown: str) -> None:
    assert escape_control_characters(text) == shown


def test_a_name_fits_in_one_line() -> None:
    assert single_line(" Ana\r\n\x1b[2J  Lopez ", 64) == "Ana [2J Lopez"
    assert single_line("x" * 100, 64) == "x" * 64


def test_colours_are_kept_if_asked_for() -> None:
    text = "\x1b[1;92mgreen\x1b[0m\x1b[2J\x1b[38:5:1mred\x07"
    shown = "\x1b[1;92mgreen\x1b[0m\\x1b[2J\x1b[38:5:1mred\\x07"
    assert escape_control_characters(text, keep_colours=True) == shown


def test_a_terminal_gets_no_control_characters_except_our_own() -> None:
    original = io.StringIO()
    stream = TerminalStream(original)
    print("\x1b[2Jgone", "\x1b", sep="\n", file=cast("TextIO", stream))
    stream.writelines(["\x07", "é\n"])
    write_styled(stream, "\x1b[H")
    write_styled(original, "\x1b[K")
    assert original.getvalue() == "\\x1b[2Jgone\n\\x1b\n\\x07é\n\x1b[H\x1b[K"
    assert stream.isatty() is False
