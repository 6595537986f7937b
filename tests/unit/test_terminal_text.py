from __future__ import annotations

import pytest

from zbot.terminal_text import escape_control_characters, single_line


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
