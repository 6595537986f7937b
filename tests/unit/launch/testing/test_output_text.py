from __future__ import annotations

import re
from typing import Any

import pytest

from zbot.errors import ArgumentTypeError
from zbot.launch.testing.output_text import (
    basic_output_filter,
    has_expected,
    ros_output_filter,
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
def test_an_invalid_expectation_is_refused(expected: Any) -> None:
    with pytest.raises(ArgumentTypeError):
        has_expected(expected, TEXT)


def test_escape_sequences_are_left_out() -> None:
    assert without_escapes("\x1b[33m[WARN]\x1b[0m x\x1b]0;title\x07y") == "[WARN] xy"


def test_lines_can_be_left_out() -> None:
    keep = basic_output_filter(filtered_prefixes=["DDS", b"pid"], filtered_patterns=["^.*noise"])
    assert keep("DDS x\npid 5\nmore noise\ngood\n") == "good\n"
    assert basic_output_filter()("pid 5\nDDS x\n") == "DDS x\n"
    of_nodes = ros_output_filter(["WARN"], filtered_rmw_implementation="rmw_zbot_zenoh")
    assert of_nodes("WARN\nx\n") == "x\n"
