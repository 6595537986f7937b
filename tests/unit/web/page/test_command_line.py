"""Test of command lines quoted for a shell."""

from __future__ import annotations

import shlex

import pytest

from zbot.web.page.command_line import command_line


@pytest.mark.parametrize(
    ("word", "typed"),
    [
        ("/turtle1/cmd_vel", "/turtle1/cmd_vel"),
        ("{linear: {x: 2.0}}", '"{linear: {x: 2.0}}"'),
        ("it's", '"it\'s"'),
        ('say "hi"', "'say \"hi\"'"),
        ("$HOME", "'$HOME'"),
        ("", '""'),
        ("a;b", '"a;b"'),
    ],
)
def test_words_are_quoted_for_a_shell(word: str, typed: str) -> None:
    assert command_line("topic", "pub", word) == f"zbot topic pub {typed}"
    assert shlex.split(typed) == [word]
