from __future__ import annotations

import re
from typing import Any

import pytest

from zbot.errors import ArgumentTypeError
from zbot.launch_test.output_text import (
    basic_output_filter,
    expect_output,
    has_expected,
    without_escapes,
)

TEXT = "first\nsecond line\r\nthird\n"


@pytest.mark.parametrize(
    ("expected", "found"),
    [
        ("second", True),
        ("fourth", False),
        (["first", "third"], True),
        (["third", "first"], False),
        (["second"], False),  # in a list, whole lines
        (re.compile("s.c+ond"), True),
        (re.compile("second line$", re.MULTILINE), True),
        ([re.compile("irst"), re.compile("hird")], True),
        ([re.compile("hird"), re.compile("irst")], False),
    ],
)
def test_texts_lines_and_patterns_are_found(expected: Any, *, found: bool) -> None:
    assert has_expected(expected, TEXT) is found


@pytest.mark.parametrize("expected", [5, None, [], ["a", 5]])
def test_what_is_no_expectation_is_refused(expected: Any) -> None:
    with pytest.raises(ArgumentTypeError):
        has_expected(expected, TEXT)


def test_escapes_of_terminals_are_left_out() -> None:
    assert without_escapes("\x1b[33m[WARN]\x1b[0m x\x1b]0;title\x07y") == "[WARN] xy"


def test_lines_can_be_left_out() -> None:
    keep = basic_output_filter(filtered_prefixes=["DDS", b"pid"], filtered_patterns=["^.*noise"])
    assert keep("DDS x\npid 5\nmore noise\ngood\n") == "good\n"


def test_an_output_is_compared_in_whole_or_in_part() -> None:
    assert expect_output(expected_text="b", text="abc")
    assert not expect_output(expected_text="b", text="abc", strict=True)
    assert expect_output(expected_text=re.compile("a.c"), text="abc", strict=True)
    assert expect_output(expected_lines=["b", None], lines=["a", "b", "c"])
    assert not expect_output(expected_lines=["b", "a"], lines=["a", "b", "c"])
    assert expect_output(expected_lines=[re.compile("a+"), None], text="aa\nb", strict=True)
    assert not expect_output(expected_lines=["aa"], text="aa\nb", strict=True)
