from __future__ import annotations

import math
from typing import Any

import pytest

import zbot  # noqa: F401 - makes the message packages importable
from zbot.parameters.parameter import Parameter
from zbot.parameters.validation import Descriptor, Range, rejection_reason, widened

Type = Parameter.Type


def refused(descriptor: Descriptor, value: object, present: object = None) -> str:
    now: Parameter[Any] | None = None if present is None else Parameter("p", value=present)
    return rejection_reason(widened(Parameter("p", value=value), descriptor), descriptor, now)


INTEGER = Descriptor(Type.INTEGER, integer_range=Range(0, 255, 5))
DOUBLE = Descriptor(Type.DOUBLE, floating_point_range=Range(-0.9, 10.0, 0.3))


@pytest.mark.parametrize("value", [0, 255, 5, 250])
def test_integers_on_a_step_are_allowed(value: int) -> None:
    assert not refused(INTEGER, value)


@pytest.mark.parametrize("value", [-0.9, 10.0, 10.000001, 0.0, 0.3, 0.3000001, 9])
def test_floats_close_to_a_step_are_allowed(value: float) -> None:
    assert not refused(DOUBLE, value)


@pytest.mark.parametrize(
    ("descriptor", "value", "sentence"),
    [
        (
            INTEGER,
            300,
            "Parameter p out of range. Min: 0, Max: 255, value: 300 (integer, now 50)",
        ),
        (
            INTEGER,
            7,
            (
                "The parameter value for p is not a valid step. "
                "Min: 0, max: 255, value: 7, step: 5 (integer, now 50)"
            ),
        ),
        (
            DOUBLE,
            0.4,
            (
                "The parameter value for p is not close enough to a valid step. "
                "Min: -0.9, max: 10.0, value: 0.4, step: 0.3 (double, now 50)"
            ),
        ),
        (
            DOUBLE,
            math.nan,
            "Parameter p out of range. Min: -0.9, Max: 10.0, value: nan (double, now 50)",
        ),
        (
            INTEGER,
            "hello",
            (
                "Wrong parameter type, expected 'integer' got 'string': "
                "p takes a value of type integer from 0 to 255 in steps of 5, and is 50"
            ),
        ),
        (
            Descriptor(Type.INTEGER),
            5.0,
            (
                "Wrong parameter type, expected 'integer' got 'double': "
                "p takes a value of type integer, and is 50"
            ),
        ),
        (Descriptor(Type.INTEGER), None, "Static parameter cannot be undeclared"),
        (
            Descriptor(Type.INTEGER, read_only=True),
            5,
            "Trying to set a read-only parameter: p.",
        ),
    ],
)
def test_a_refusal_names_its_reason(descriptor: Descriptor, value: object, sentence: str) -> None:
    assert refused(descriptor, value, 50) == sentence


def test_a_range_may_be_given_in_reverse() -> None:
    backwards = Descriptor(Type.INTEGER, integer_range=Range(10, 0))
    assert not refused(backwards, 5)
    assert "Min: 0, Max: 10" in refused(backwards, 11)


def test_a_dynamic_parameter_takes_any_type_but_keeps_its_ranges() -> None:
    dynamic = Descriptor(dynamic_typing=True, integer_range=Range(0, 10))
    assert not refused(dynamic, "hello", 5)
    assert not refused(dynamic, 50.0, 5)
    assert not refused(dynamic, None, 5)
    assert "out of range" in refused(dynamic, 11, 5)


@pytest.mark.parametrize(
    ("declared", "value", "expected"),
    [
        (Type.DOUBLE, 2, 2.0),
        (Type.DOUBLE_ARRAY, [1, 2], [1.0, 2.0]),
        (Type.STRING_ARRAY, [], []),
        (Type.INTEGER, 2.0, 2.0),
        (Type.INTEGER_ARRAY, [1.5], [1.5]),
    ],
)
def test_values_widen_to_the_declared_type(
    declared: Parameter.Type, value: Any, expected: object
) -> None:
    result = widened(Parameter("p", value=value), Descriptor(declared))
    assert repr(result.value) == repr(expected)


def test_an_integer_too_large_for_a_float_is_rejected() -> None:
    huge = Parameter("p", value=2**62)
    assert widened(huge, Descriptor(Type.DOUBLE)).value == 2.0**62


def test_a_descriptor_survives_the_message() -> None:
    full = Descriptor(
        Type.DOUBLE,
        "how fast",
        "not on Sundays",
        read_only=True,
        floating_point_range=Range(0.0, 1.0, 0.25),
        integer_range=Range(0, 10, 2),
    )
    message = full.to_message("speed")
    assert message.name == "speed"
    assert Descriptor.of(message) == full
    assert Descriptor.of(Descriptor().to_message("p")) == Descriptor()
