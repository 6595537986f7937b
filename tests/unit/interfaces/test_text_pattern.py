"""Tests of the patterns of filters: what they match, and that no text takes long."""

from __future__ import annotations

import fnmatch
import re
import subprocess
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.conftest import allowed
from zbot.interfaces.text_pattern import PatternError, RegularExpression, like_expression

TEXTS = st.text("abc1 \n.", max_size=12)
_ATOMS = st.sampled_from(
    ["a", "b", ".", "[ab]", "[^a]", r"\d", r"\W", r"\.", "[]a]", r"\x61", "{", "}", ""]
)
_COUNTS = st.sampled_from(["", "", "*", "+", "?", "*?", "{2}", "{1,}", "{,2}", "{0,3}", "{0}"])
PATTERNS = st.recursive(
    _ATOMS,
    lambda inner: st.one_of(
        st.lists(inner, min_size=1, max_size=3).map("".join),
        st.lists(inner, min_size=1, max_size=3).map(lambda parts: f"({'|'.join(parts)})"),
        st.tuples(inner, _COUNTS).map(lambda pair: f"(?:{pair[0]}){pair[1]}"),
    ),
    max_leaves=6,
)


@given(pattern=PATTERNS, texts=st.lists(TEXTS, max_size=4))
def test_an_expression_matches_what_python_matches(pattern: str, texts: list[str]) -> None:
    expression = RegularExpression(pattern)
    for text in texts:
        assert expression.matches(text) == (re.fullmatch(pattern, text) is not None)


@given(pattern=PATTERNS, texts=st.lists(TEXTS, max_size=4))
def test_an_expression_matches_the_beginnings_that_python_matches(
    pattern: str, texts: list[str]
) -> None:
    for written in (pattern, f"^{pattern}|b$", f"^(?:{pattern})$|^b"):
        expression = RegularExpression(written, is_whole=False)
        for text in texts:
            end = r"\Z"  # `$` of Python also matches before the end of the last line
            expected = re.match(written.replace("$", end), text) is not None
            assert expression.matches(text) == expected


@pytest.mark.parametrize(
    ("pattern", "text", "expected"),
    [
        ("^arm_[0-9]+$", "arm_17", True),
        ("^arm_[0-9]+$", "arm_", False),
        ("^arm$|^leg$", "leg", True),
        (r"(?P<side>left|right)/wheel", "right/wheel", True),
        ("a|", "", True),
        (r"cost\$", "cost$", True),
        ("(a+)+b", "a" * 5000 + "b", True),
    ],
)
def test_expressions_and_texts(pattern: str, text: str, *, expected: bool) -> None:
    assert RegularExpression(pattern).matches(text) is expected


@pytest.mark.parametrize(
    "pattern",
    [
        "(",
        f"a{{{'9' * 5000}}}",
        r"(a)\1",
        "(?=a)b",
        "(?<!a)b",
        "(?i)a",
        r"\ba",
        "a^b",
        "(a{900}){900}",
        "((){1999}){1999}",
        "a{99999}",
        "[a-\uffff]" * 1000,
        r"[a-\uffff]" * 1000,
        "(" * 60 + "a" + ")" * 60,
        "[",
    ],
)
def test_other_expressions_are_refused(pattern: str) -> None:
    with pytest.raises(PatternError) as caught:
        RegularExpression(pattern)
    assert str(caught.value)


SLOW = """
import sys
from zbot.interfaces.text_pattern import RegularExpression, like_expression
pattern, text = sys.argv[2], sys.argv[3] * int(sys.argv[4])
expression = like_expression(pattern) if sys.argv[1] == "like" else RegularExpression(pattern)
getattr(expression, "fullmatch" if sys.argv[1] == "like" else "matches")(text)
"""


@pytest.mark.parametrize(
    ("kind", "pattern", "text", "times"),
    [
        ("match", "(a+)+b", "a", 60_000),
        ("match", "(a|a)*b", "a", 60_000),
        ("match", "(.*)(.*)(.*)(.*)x", "a", 60_000),
        ("match", "(a?){300}a{300}", "a", 300),
        ("match", "(.|a)*a.{300}(.|a)*b", "abbaababbabaaab", 4_000),
        ("like", "%a%a%a%a%a%a%a%a%b", "a", 20_000),
        ("like", "%_a%_a%_a%_a%b%c", "ab", 10_000),
    ],
)
def test_no_text_takes_long(kind: str, pattern: str, text: str, times: int) -> None:
    """`re` holds the interpreter, so a process of its own tries it."""
    words = [sys.executable, "-c", SLOW, kind, pattern, text, str(times)]
    subprocess.run(words, check=True, timeout=allowed(10))


@given(pattern=st.text("ab%*_?.", max_size=8), text=st.text("abc.%\n", max_size=10))
def test_like_matches_what_its_wildcards_mean(pattern: str, text: str) -> None:
    glob = pattern.replace("%", "*").replace("_", "?")
    expected = fnmatch.fnmatchcase(text, glob)
    assert (like_expression(pattern).fullmatch(text) is not None) == expected
