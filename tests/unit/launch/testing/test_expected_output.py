from __future__ import annotations

import re
from functools import partial
from typing import TYPE_CHECKING, Any

import pytest

from zbot.errors import ArgumentTypeError
from zbot.launch.testing.error import LaunchTestError
from zbot.launch.testing.expected_output import expect_output, expected_output_from_file

if TYPE_CHECKING:
    from pathlib import Path

OUTPUT = "ready\nrate: 1.00\nrate: 2.00\n"
RATE = re.compile(r"rate: \d")


@pytest.mark.parametrize(
    ("expected", "somewhere", "from_the_beginning"),
    [
        (["ready", RATE], True, True),  # more output may follow: the program still runs
        (["ready", "2.00"], True, False),  # a gap; a text may be anywhere in its line
        ([RATE, RATE], True, False),
        ([RATE, RATE, RATE], False, False),
        (["rate", "ready"], False, False),
        ("ready", True, False),
        (RATE, True, False),
        (re.compile("r"), True, True),
        (iter(["ready", RATE]), True, None),
    ],
)
def test_lines_come_in_order(
    expected: Any, *, somewhere: bool, from_the_beginning: bool | None
) -> None:
    assert expect_output(OUTPUT, expected_lines=expected) is somewhere
    if from_the_beginning is not None:
        assert expect_output(OUTPUT, expected_lines=expected, strict=True) is from_the_beginning


@pytest.mark.parametrize(
    ("expected", "somewhere", "from_the_beginning"),
    [
        (OUTPUT, True, True),
        ("rate", True, False),
        (re.compile("ready"), True, True),
        (["ready\n", RATE], True, True),
        (["ready", "2.00"], True, False),
        (["2.00", "ready"], False, False),
    ],
)
def test_texts_come_in_order(expected: Any, *, somewhere: bool, from_the_beginning: bool) -> None:
    assert expect_output(OUTPUT, expected_text=expected) is somewhere
    assert expect_output(OUTPUT, expected_text=expected, strict=True) is from_the_beginning


def test_the_output_may_be_a_text_or_lines() -> None:
    is_there = partial(expect_output, expected_lines=["ready"], strict=True)
    assert is_there(OUTPUT)
    assert is_there(lines=["ready"])
    assert is_there("\x1b[32mready\x1b[0m\r\n")
    assert not is_there("")
    assert expect_output(lines=["", "x"], expected_lines=["", "x"], strict=True)


@pytest.mark.parametrize(
    "arguments",
    [
        {"expected_lines": "x"},
        {"text": "x"},
        {"text": "x", "lines": ["x"], "expected_text": "x"},
        {"text": "x", "expected_text": "x", "expected_lines": "x"},
    ],
)
def test_one_output_is_compared_with_one_expectation(arguments: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="expect_output takes either"):
        expect_output(**arguments)


@pytest.mark.parametrize("expected", [5, [], ["x", None]])
def test_an_invalid_expectation_is_refused(expected: Any) -> None:
    with pytest.raises(ArgumentTypeError):
        expect_output("x", expected_lines=expected)


def test_expectations_are_read_from_files(tmp_path: Path) -> None:
    (tmp_path / "lines.txt").write_text("ready\nrate\n")
    (tmp_path / "patterns.regex").write_text("r.*y\n")
    assert expected_output_from_file(str(tmp_path / "lines")) == ["ready", "rate"]
    assert expected_output_from_file(str(tmp_path / "patterns")) == [re.compile("r.*y")]
    with pytest.raises(LaunchTestError, match="neither"):
        expected_output_from_file(str(tmp_path / "missing"))
