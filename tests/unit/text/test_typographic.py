"""Characters of word processors: the advice says which key to press."""

# ruff: noqa: RUF001 - these characters are the subject

from __future__ import annotations

import pytest

from zbot.text.typographic import advice, advice_for_words, advise_of_syntax


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("{“data”: 1}", 'type " in place of “ (U+201C)'),
        ("‘a’", "type ' in place of ‘ (U+2018)"),
        ("5 – 3", "type - in place of – (U+2013)"),
        ("data： hi", "type : in place of ： (U+FF1A)"),
        ("a…", "type ... in place of … (U+2026)"),
        ("\u00a0x", "the character U+00A0 only looks like a space: type a space"),
        ("x\u200b", "delete the invisible character U+200B"),
        ("plain \"text\" - 'it' äöü 中", ""),
    ],
)
def test_the_first_such_character_is_named(text: str, expected: str) -> None:
    assert advice(text) == expected


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["topic", "list", "–verbose"], "type --verbose in place of –verbose"),
        (["topic", "pub", "—-once"], "type --once in place of —-once"),
        (["–h"], "type -h in place of –h"),
        (["pub", "/t", "“{data:", "hi}”"], 'type " in place of “ (U+201C)'),
        (["pub", "/t", "{data: “hi”}", ""], ""),
    ],
)
def test_a_word_of_a_command_that_begins_with_one(words: list[str], expected: str) -> None:
    assert advice_for_words(words) == expected


@pytest.mark.parametrize(
    ("line", "advised"),
    [
        ("print(“hi”)", 'type " in place of “'),
        ("print(‘hi’)", "type ' in place of ‘"),
        ('print("hi”)', 'type " in place of ”'),
        ("x = 5 – 3", "type - in place of –"),
        ("x\u00a0= 5", "type a space"),
        ("x = 5\u200b", "delete the invisible character U+200B"),
        ("print（'hi'）", "type ( in place of （"),
        ("if True：\n    x = 1", "type : in place of ："),
        ("x = 5 × 3", "type * in place of ×"),
        ("if 3 ≤ 4: x = 1", "type <= in place of ≤"),
        ("if True:\n        x = 1\n\ty = 2", "indent this line with the same spaces"),
    ],
)
def test_a_syntax_error_says_what_to_type(line: str, advised: str) -> None:
    with pytest.raises(SyntaxError) as caught:
        compile(line, "robot.py", "exec")
    advise_of_syntax(caught.value)
    advise_of_syntax(caught.value)
    text = str(caught.value)
    assert text.count(advised) == 1
    assert caught.value.lineno is not None


@pytest.mark.parametrize("line", ["print('“ok”' +)", "x = = 1", "print('ok"])
def test_other_syntax_errors_are_left_alone(line: str) -> None:
    with pytest.raises(SyntaxError) as caught:
        compile(line, "robot.py", "exec")
    before = str(caught.value)
    advise_of_syntax(caught.value)
    assert str(caught.value) == before
