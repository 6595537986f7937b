"""Expressions of content filters; what is admitted was compared with Fast DDS."""

from __future__ import annotations

from typing import Any

import pytest

from zbot.interfaces.content_filter import ContentFilter, ContentFilterError

from geometry_msgs.msg import Twist, Vector3
from std_msgs.msg import Bool, Float32MultiArray, Int32, String

INTS = [Int32(data=number) for number in range(7)]
BOOLS = [Bool(data=False), Bool(data=True)]
TEXTS = [String(data=text) for text in ("abc", "abd", "xbc", "", "a%c", "ABC")]
TWISTS = [Twist(linear=Vector3(x=float(number), y=1.0)) for number in range(4)]
LISTS = [Float32MultiArray(data=[float(length)] * length) for length in range(4)]


def chosen(messages: list[Any], expression: str, *parameters: str) -> list[int]:
    content = ContentFilter(expression, parameters, type(messages[0]))
    return [number for number, one in enumerate(messages) if content.admits(one)]


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
def test_messages_of_which_the_expression_is_true_are_admitted(
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
        (INTS, "data >", "something is missing at its end"),
        (INTS, "data", "a comparison is missing"),
        (INTS, "data > %0", "no parameter for %0"),
        (INTS, "data in (1, 2)", "cannot be read"),
        (INTS, "data > '3'", "a number cannot be compared with a text"),
        (INTS, "data > TRUE", "a number cannot be compared with a truth value"),
        (INTS, "data LIKE 3", "LIKE needs texts"),
        (INTS, "(data > 3", "')' is missing"),
        (INTS, "data > 3 data", "'data' is too much"),
        (INTS, "data > AND", "stands where a field or a value belongs"),
        (TEXTS, "'a' = 'a'", "needs a field"),
        (TEXTS, "data NOT LIKE 'a'", "a comparison is missing"),
        (TEXTS, "data MATCH '('", "is no regular expression"),
        (TWISTS, "linear > 3", "linear is no number, text or truth value"),
    ],
)
def test_what_cannot_be_applied_is_refused_with_the_reason(
    messages: list[Any], expression: str, reason: str
) -> None:
    with pytest.raises(ContentFilterError) as caught:
        chosen(messages, expression)
    assert reason in str(caught.value)


def test_a_parameter_that_is_no_value_is_refused() -> None:
    with pytest.raises(ContentFilterError, match="write texts in quotes"):
        chosen(TEXTS, "data = %0", "abc")
