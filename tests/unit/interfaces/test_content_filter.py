"""Tests of expressions of content filters; the expected results equal those of Fast DDS."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.interfaces.content_filter import ContentFilter, ContentFilterError

from geometry_msgs.msg import Twist, Vector3
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Bool, Float32MultiArray, Int32, String

INTS = [Int32(data=number) for number in range(7)]
BOOLS = [Bool(data=False), Bool(data=True)]
TEXTS = [String(data=text) for text in ("abc", "abd", "xbc", "", "a%c", "ABC")]
TWISTS = [Twist(linear=Vector3(x=float(number), y=1.0)) for number in range(4)]
LISTS = [Float32MultiArray(data=[float(length)] * length) for length in range(4)]


def chosen(messages: list[Any], expression: str, *parameters: str) -> list[int]:
    content = ContentFilter(expression, parameters, type(messages[0]))
    return [number for number, message in enumerate(messages) if content.matches(message)]


@pytest.mark.parametrize(
    ("messages", "expression", "expected"),
    [
        (INTS, "data > 3 AND data < 6", [4, 5]),
        (INTS, "data BETWEEN 2 AND 4", [2, 3, 4]),
        (INTS, "data not between 2 and 4", [0, 1, 5, 6]),
        (INTS, "data <> 3", [0, 1, 2, 4, 5, 6]),
        (INTS, "(data >= 5)", [5, 6]),
        (INTS, "3 < data", [4, 5, 6]),
        (INTS, "data > 3.5", [4, 5, 6]),
        (INTS, "data = 0x5", [5]),
        (INTS, "NOT(NOT(data = +2))", [2]),
        (INTS, "NOT data = 2 AND data = 2", []),
        (INTS, "data = 1 OR data = 2 AND data = 3 OR data = 0", [0]),
        (INTS, "data = 1 OR (data = 2 AND data = 3) OR data = 0", [0, 1]),
        (BOOLS, "data = TRUE", [1]),
        (BOOLS, "data = 1", [1]),
        (TEXTS, "data LIKE 'ab%'", [0, 1]),
        (TEXTS, "data LIKE 'ab_'", [0, 1]),
        (TEXTS, "data MATCH 'a.c'", [0, 4]),
        (TEXTS, "data MATCH 'a'", []),
        (TEXTS, "data > 'abd'", [2]),
        (TEXTS, "'abc' = data", [0]),
        (TWISTS, "linear.x > linear.y", [2, 3]),
        (TWISTS, "linear.x >= -1.0e0 AND linear.y = 1", [0, 1, 2, 3]),
        (LISTS, "data[1] > 1", [2, 3]),
        (LISTS, "layout.dim[0].size = 0", []),
    ],
)
def test_messages_that_match_the_expression_are_received(
    messages: list[Any], expression: str, expected: list[int]
) -> None:
    assert chosen(messages, expression) == expected


def test_parameters_stand_for_values() -> None:
    assert chosen(INTS, "data > %0 AND data < %1", "2", "5") == [3, 4]
    assert chosen(TEXTS, "data LIKE %0", "'a%'") == [0, 1, 4]
    assert chosen(BOOLS, "data = %0", "true") == [1]


@pytest.mark.parametrize(
    ("messages", "expression", "reason"),
    [
        (INTS, "bogus > 3", "its fields are data"),
        (INTS, "Data > 3", "did you mean 'data'"),
        (INTS, "data >", "a field or a value is missing at the end"),
        (INTS, "data", "a comparison is missing"),
        (INTS, "data > %0", "no parameter for %0"),
        (INTS, "data in (1, 2)", "cannot be read"),
        (INTS, "data > '3'", "a number cannot be compared with a string"),
        (INTS, "data > TRUE", "a number cannot be compared with a bool"),
        (INTS, "data LIKE 3", "LIKE needs strings on both sides"),
        (INTS, "(data > 3", "')' is missing"),
        (INTS, "data > 3 data", "'data' is unexpected"),
        (INTS, "data > AND", "a field or a value is needed in place of 'AND'"),
        (TEXTS, "'a' = 'a'", "needs a field"),
        (TEXTS, "data NOT LIKE 'a'", "a comparison is missing"),
        (TEXTS, "data MATCH '('", "is not a regular expression"),
        (TWISTS, "linear > 3", "linear is not a number, string or bool"),
    ],
)
def test_an_invalid_expression_is_rejected_with_the_reason(
    messages: list[Any], expression: str, reason: str
) -> None:
    with pytest.raises(ContentFilterError) as caught:
        chosen(messages, expression)
    assert reason in str(caught.value)


def test_a_parameter_that_is_not_a_value_is_rejected() -> None:
    with pytest.raises(ContentFilterError, match="put strings in quotes"):
        chosen(TEXTS, "data = %0", "abc")


@pytest.mark.parametrize(
    "expression",
    [
        "ranges[0] LIKE 'a'",
        "ranges[0] = 'a'",
        "ranges[0:2] = 1",
        "ranges = 1",
        "ranges[0].x = 1",
        "ranges[0] = TRUE",
    ],
)
def test_elements_of_empty_lists_have_a_type(expression: str) -> None:
    with pytest.raises(ContentFilterError):
        ContentFilter(expression, (), LaserScan)
