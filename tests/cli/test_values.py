"""Values on a command line, and filters: tables."""

from __future__ import annotations

from typing import Any

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot_cli.filter import FilterError, compile_filter
from zbot_cli.types import InvalidTypeError, looks_like_type, resolve_message_type
from zbot_cli.values import PopulateError, ValuesError, populate, split_documents

from geometry_msgs.msg import PoseStamped, Twist  # isort: skip
from sensor_msgs.msg import JointState  # isort: skip
from std_msgs.msg import Bool, Float32, Int8, String  # isort: skip

NOW_NS = 5_000_000_007


def make(message_type: type[Any], text: str) -> Any:
    return populate(message_type, text, lambda: NOW_NS)


@pytest.mark.parametrize(
    "text",
    [
        "{linear: {x: 2.0}, angular: {z: 1.8}}",
        '{"linear": {"x": 2.0}, "angular": {"z": 1.8}}',
        "linear:\n  x: 2.0\nangular:\n  z: 1.8\n",
        "linear.x=2 angular.z=1.8",
    ],
)
def test_every_way_of_writing_a_twist(text: str) -> None:
    message = make(Twist, text)
    assert (message.linear.x, message.linear.y, message.angular.z) == (2.0, 0.0, 1.8)


@pytest.mark.parametrize("text", ["", "{}", "   "])
def test_nothing_means_defaults(text: str) -> None:
    assert make(Twist, text) == Twist()


@pytest.mark.parametrize(
    ("message_type", "text", "wanted"),
    [
        (String, "data: 5", "5"),
        (String, "data: true", "true"),
        (String, "data: ", ""),
        (Float32, "data: 1", 1.0),
        (Float32, "data: '2.5'", 2.5),
        (Int8, "data: 3.0", 3),
        (Bool, "data: true", True),
        (Bool, "data: 1", True),
    ],
)
def test_values_are_cast_to_the_field(message_type: type[Any], text: str, wanted: object) -> None:
    assert make(message_type, text).data == wanted


def test_a_header_can_be_filled_with_now() -> None:
    for text in ("{header: auto}", "{header: {stamp: now}}"):
        stamp = make(PoseStamped, text).header.stamp
        assert (stamp.sec, stamp.nanosec) == (5, 7)


def test_lists_replace_lists() -> None:
    message = make(JointState, "{name: [a, b], position: [1, 2.5]}")
    assert (message.name, list(message.position)) == (["a", "b"], [1.0, 2.5])


@pytest.mark.parametrize(
    ("message_type", "text", "sentence", "hint"),
    [
        (String, "{dat: x}", "'String' object has no attribute 'dat'", "did you mean 'data'?"),
        (Float32, "{data:1}", "no attribute 'data:1'", "put a blank after the colon: data: 1"),
        (Float32, "{data: abc}", "could not convert string to float: 'abc'", None),
        (Int8, "{data: 200}", "200", None),
        (Int8, "{data: 1.5}", "whole number", None),
        (Bool, "{data: maybe}", "give it true or false", None),
        (Twist, "{linear: 3}", "Value '3' is expected to be a dictionary but is a int", None),
        (JointState, "{name: a}", "give it a list", None),
    ],
)
def test_a_value_that_does_not_fit_is_told(
    message_type: type[Any], text: str, sentence: str, hint: str | None
) -> None:
    with pytest.raises(PopulateError) as caught:
        make(message_type, text)
    assert sentence in str(caught.value)
    if hint is not None:
        assert caught.value.hint == hint


@pytest.mark.parametrize("text", ["abc", "[1, 2]", "5"])
def test_something_else_than_a_dictionary_is_refused(text: str) -> None:
    with pytest.raises(ValuesError, match="needs to be a dictionary in YAML format"):
        make(String, text)


def test_a_syntax_error_points_at_its_place() -> None:
    with pytest.raises(ValuesError) as caught:
        make(String, "{data: [1}")
    assert str(caught.value).endswith("(line 1, column 10)\n  {data: [1}\n           ^")


def test_a_saved_echo_is_a_list_of_documents() -> None:
    assert split_documents("data: a\n---\ndata: b\n---\n") == ["data: a\n", "\ndata: b\n"]


# -- filters ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("m.linear.x > 1", True),
        ("m.linear.x > 1 and m.angular.z < 0", False),
        ("not m.linear.x == 2.0", False),
        ("abs(m.angular.z) + 1 >= 2.8", True),
        ("1 < m.linear.x < 3", True),
        ("m.linear.x in [1, 2]", True),
        ("-m.linear.x < 0", True),
        ("m.linear.x % 2 == 0", True),
    ],
)
def test_filters_compare_and_reckon(expression: str, wanted: bool) -> None:
    assert compile_filter(expression)(make(Twist, "linear.x=2 angular.z=1.8")) is wanted


@pytest.mark.parametrize(
    "expression",
    [
        "__import__('os')",
        "m.__class__",
        "open('x')",
        "m.linear._x",
        "(lambda: 1)()",
        "[x for x in m]",
        "m.linear.x ** 1000000",
        "f'{m}'",
        "exec('1')",
        "x > 1",
        "m.x(",
        "len(m, key=1)",
        "1 if m else 2",
        "+".join("1" for _ in range(500)),
    ],
)
def test_a_filter_can_do_nothing_else(expression: str) -> None:
    with pytest.raises(FilterError, match="Invalid filter expression"):
        compile_filter(expression)


@pytest.mark.parametrize(
    "expression", ["m.nope > 1", "m.linear > 1", "m.linear.x / 0", "'a' * 9 == m"]
)
def test_a_filter_that_does_not_fit_is_told_at_the_first_message(expression: str) -> None:
    with pytest.raises(FilterError):
        compile_filter(expression)(Twist())


# -- types -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("word", ["std_msgs/msg/String", "std_msgs/String", "std_msgs.msg.String"])
def test_types_can_be_written_in_three_ways(word: str) -> None:
    assert looks_like_type(word)
    assert resolve_message_type(word) == "std_msgs/msg/String"


def test_a_short_name_is_enough_if_it_is_the_only_one() -> None:
    assert resolve_message_type("TwistWithCovarianceStamped").startswith("geometry_msgs/msg/")
    with pytest.raises(InvalidTypeError) as caught:
        resolve_message_type("String")
    assert caught.value.hint is not None
    assert "std_msgs/msg/String" in caught.value.hint


@pytest.mark.parametrize("word", ["{data: 1}", "data: 1", "linear.x=2", "data"])
def test_values_do_not_look_like_types(word: str) -> None:
    assert not looks_like_type(word)
