from __future__ import annotations

import enum
import math
from array import array
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.unit.interfaces.test_classes import define
from zbot.interfaces import get_message
from zbot.interfaces.errors import FieldTypeError, FieldValueError


class Level(enum.IntEnum):
    LOW = 1


class Colour(str, enum.Enum):
    RED = "red"


POINT: Any = get_message("geometry_msgs/msg/Point")


@pytest.mark.parametrize(
    ("line", "value", "stored"),
    [
        ("float64 x", 1, 1.0),
        ("float64 x", 2**53, float(2**53)),
        ("float64 x", np.float32(0.5), 0.5),
        ("float64 x", np.float64(0.5), 0.5),
        ("float64 x", np.int16(3), 3.0),
        ("float64 x", Fraction(1, 2), 0.5),
        ("float64 x", math.inf, math.inf),
        ("float32 x", math.inf, math.inf),
        ("float32 x", -math.inf, -math.inf),
        ("float32 x", 3.4028234663852886e38, 3.4028234663852886e38),
        ("int8 x", -128, -128),
        ("uint64 x", 2**64 - 1, 2**64 - 1),
        ("int32 x", np.uint8(200), 200),
        ("int32 x", Level.LOW, 1),
        ("int32 x", True, 1),
        ("char x", 255, 255),
        ("bool x", True, True),
        ("bool x", np.bool_(True), True),
        ("byte x", b"\xff", b"\xff"),
        ("byte x", bytearray(b"\x01"), b"\x01"),
        ("string x", "grüße 🐢", "grüße 🐢"),
        ("string x", np.str_("text"), "text"),
        ("string x", Colour.RED, "red"),
        ("string<=3 x", "äöü", "äöü"),
        ("wstring x", "w", "w"),
        ("float64[] x", [1, 2.5], array("d", [1.0, 2.5])),
        ("float64[] x", (1.0,), array("d", [1.0])),
        ("float64[] x", range(3), array("d", [0.0, 1.0, 2.0])),
        ("float64[] x", {1.0}, array("d", [1.0])),
        ("float64[] x", memoryview(b"\x02"), array("d", [2.0])),
        ("int32[] x", [2, True], array("i", [2, 1])),
        ("int8[] x", b"\x01\xff", array("b", [1, -1])),
        ("float64[] x", array("i", [1]), array("d", [1.0])),
        ("float64[] x", np.arange(2), array("d", [0.0, 1.0])),
        ("float64[] x", np.array([1.5], np.float32), array("d", [1.5])),
        ("float64[] x", np.arange(6.0)[::2], array("d", [0.0, 2.0, 4.0])),
        ("float64[] x", np.array([1.0], ">f8"), array("d", [1.0])),
        ("float64[] x", [np.float64(1.0), Fraction(1, 2)], array("d", [1.0, 0.5])),
        ("float32[] x", [1.0, math.inf], array("f", [1.0, math.inf])),
        ("float32[] x", np.array([1.0, -math.inf]), array("f", [1.0, -math.inf])),
        ("uint8[] x", b"\x00\xff", array("B", [0, 255])),
        ("uint8[] x", bytearray(b"\x01"), array("B", [1])),
        ("uint8[] x", memoryview(b"\x02"), array("B", [2])),
        ("uint8[] x", np.array([255], np.int64), array("B", [255])),
        ("uint8[] x", np.array([], np.int64), array("B")),
        ("char[] x", b"ab", array("B", [97, 98])),
        ("int64[] x", [Level.LOW], array("q", [1])),
        ("int64[<=2] x", [1, 2], array("q", [1, 2])),
        ("bool[] x", (True, False), [True, False]),
        ("bool[] x", np.array([True]), [True]),
        ("string[] x", ("a", "ß"), ["a", "ß"]),
        ("string<=1[] x", ["a"], ["a"]),
        ("byte[] x", [b"a"], [b"a"]),
        ("geometry_msgs/Point x", POINT(x=1), POINT(x=1)),
        ("geometry_msgs/Point[] x", (POINT(),), [POINT()]),
    ],
)  # fmt: skip
def test_valid_values_are_stored(line: str, value: object, stored: object) -> None:
    cls = define(line)
    constructed = cls(x=value)
    assigned = cls()
    assigned.x = value
    for message in (constructed, assigned):
        assert message.x == stored
        assert type(message.x) is type(stored)


def test_numbers_may_come_from_a_generator() -> None:
    message = define("float64[] x")(x=(each / 2 for each in range(3)))
    assert message.x == array("d", [0.0, 0.5, 1.0])
    message.x = map(float, "12")
    assert message.x == array("d", [1.0, 2.0])


def test_nan_is_a_number() -> None:
    message = define("float32 x")(x=math.nan)
    assert math.isnan(message.x)
    assert math.isnan(define("float32[] x")(x=np.array([math.nan])).x[0])


@pytest.mark.parametrize(
    ("line", "value", "label"),
    [
        ("float64 x", "1.0", "x"),
        ("float64 x", None, "x"),
        ("float64 x", True, "x"),
        ("float64 x", 1j, "x"),
        ("float64 x", np.array(1.0), "x"),
        ("int32 x", 1.0, "x"),
        ("int32 x", np.bool_(True), "x"),
        ("int32 x", np.float32(1), "x"),
        ("bool x", 1, "x"),
        ("byte x", 1, "x"),
        ("byte x", "a", "x"),
        ("string x", b"bytes", "x"),
        ("string x", 5, "x"),
        ("float64[] x", 1.0, "x"),
        ("float64[] x", "12", "x"),
        ("float64[] x", None, "x"),
        ("float64[] x", {1.0: 2.0}, "x"),
        ("float64[] x", [1.0, "2"], "x[1]"),
        ("float64[] x", [1.0, True], "x[1]"),
        ("float64[] x", b"\x00", "x"),
        ("float64[] x", np.array([True]), "x"),
        ("int32[] x", [1, 2.0], "x[1]"),
        ("int32[] x", np.array([1.0]), "x"),
        ("bool[] x", [True, 1], "x[1]"),
        ("string[] x", "text", "x"),
        ("string[] x", ["a", b"b"], "x[1]"),
        ("byte[] x", b"ab", "x"),
        ("byte[] x", [b"a", 1], "x[1]"),
        ("geometry_msgs/Point x", (1.0, 2.0, 3.0), "x"),
        ("geometry_msgs/Point x", POINT, "x"),
        ("geometry_msgs/Point x", None, "x"),
        ("geometry_msgs/Point[] x", [POINT(), None], "x[1]"),
        ("geometry_msgs/Point[] x", POINT(), "x"),
        ("float64[2] x", 1.0, "x"),
        ("float64[2] x", [1.0, "2"], "x[1]"),
    ],
)
def test_another_type_is_refused(line: str, value: object, label: str) -> None:
    assert_refused(FieldTypeError, line, value, label)


@pytest.mark.parametrize(
    ("line", "value", "label"),
    [
        ("int8 x", 128, "x"),
        ("int8 x", -129, "x"),
        ("uint8 x", -1, "x"),
        ("uint64 x", 2**64, "x"),
        ("int32 x", 2**40, "x"),
        ("int8 x", np.int64(200), "x"),
        ("float64 x", 10**400, "x"),
        ("float32 x", 1e39, "x"),
        ("float32 x", 10**39, "x"),
        ("byte x", b"", "x"),
        ("byte x", b"ab", "x"),
        ("string x", "\ud800", "x"),
        ("string<=2 x", "abc", "x"),
        ("string<=2[] x", ["ab", "abc"], "x[1]"),
        ("string[] x", ["\udfff"], "x[0]"),
        ("uint8[] x", [1, 256], "x[1]"),
        ("uint8[] x", np.array([1, 256]), "x[1]"),
        ("uint64[] x", np.array([-1]), "x[0]"),
        ("float32[] x", [1.0, 1e39], "x[1]"),
        ("float32[] x", np.array([1.0, 1e39]), "x[1]"),
        ("float64[] x", np.zeros((2, 2)), "x"),
        ("float64[<=2] x", [1.0, 2.0, 3.0], "x"),
        ("float64[<=2] x", array("d", [1.0, 2.0, 3.0]), "x"),
        ("bool[<=1] x", [True, True], "x"),
        ("string[2] x", ["a"], "x"),
        ("float64[4] x", [1.0], "x"),
        ("float64[4] x", np.zeros((2, 2)), "x"),
        ("float64[2] x", np.zeros(3), "x"),
    ],
)
def test_values_that_do_not_fit_a_field_are_rejected(line: str, value: object, label: str) -> None:
    assert_refused(FieldValueError, line, value, label)


def assert_refused(error: type[Any], line: str, value: object, label: str) -> None:
    cls = define(line)
    message = cls()
    before = repr(message)
    with pytest.raises(error) as at_construction:
        cls(x=value)
    with pytest.raises(error) as at_assignment:
        message.x = value
    assert repr(message) == before
    for caught in (at_construction.value, at_assignment.value):
        assert (caught.type_name, caught.field) == ("demo_msgs/msg/Demo", label)
        assert f"field {label!r} of demo_msgs/msg/Demo must be" in str(caught)


@pytest.mark.parametrize(
    ("line", "value", "sentence"),
    [
        ("float64 x", "fast", "must be a float, not str: 'fast'"),
        ("int8 x", 200, "must be an int from -128 to 127, not 200"),
        ("string<=3 x", "abcd", "must be a str of at most 3 characters, not 'abcd'"),
        ("geometry_msgs/Point x", 1, "must be a geometry_msgs/msg/Point, not int: 1"),
        ("float64[2] x", [1.0], "must be a list of 2 values, of which each is a float, not [1.0]"),
        ("float64[4] x", np.eye(2), "must be flat (use .ravel())"),
    ],
)
def test_error_messages(line: str, value: object, sentence: str) -> None:
    with pytest.raises((FieldTypeError, FieldValueError)) as caught:
        define(line)(x=value)
    assert sentence in str(caught.value)


def test_a_long_value_is_shortened_in_the_message() -> None:
    with pytest.raises(FieldTypeError) as caught:
        define("float64 x")(x="y" * 10000)
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize(
    ("line", "value"),
    [
        ("string[] x", ["a", "ä"]),
        ("string<=2[] x", ["a"]),
        ("byte[] x", [b"a"]),
        ("geometry_msgs/Point[] x", [POINT()]),
        ("float64[] x", array("d", [1.0])),
        ("float64[2] x", np.zeros(2)),
    ],
)
def test_values_of_the_exact_type_are_not_copied(line: str, value: object) -> None:
    assert define(line)(x=value).x is value


def test_fixed_arrays_take_lists_and_other_dtypes() -> None:
    cls = define("float32[2] x")
    for value in (
        [1, 2],
        (1.0, 2.0),
        np.array([1, 2]),
        array("d", [1, 2]),
        np.arange(4)[1:3],
    ):
        message = cls(x=value)
        assert message.x.dtype == np.float32
        assert message.x.tolist() == [1.0, 2.0]
    assert define("uint8[2] x")(x=b"ab").x.tolist() == [97, 98]


_RANGES = {"int8": 8, "uint8": 8, "int16": 16, "uint16": 16, "int32": 32, "uint64": 64, "int64": 64}


@given(st.sampled_from(sorted(_RANGES)), st.integers(-(2**65), 2**65))
def test_integers_are_stored_or_refused_exactly_at_the_limits(base: str, value: int) -> None:
    bits = _RANGES[base]
    low, high = (0, 2**bits - 1) if base[0] == "u" else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
    cls, sequence = _CLASSES[base]
    if low <= value <= high:
        assert cls(x=value).x == value
        assert sequence(x=[value]).x.tolist() == [value]
    else:
        with pytest.raises(FieldValueError):
            cls(x=value)
        with pytest.raises(FieldValueError):
            sequence(x=[value])


_CLASSES = {base: (define(f"{base} x"), define(f"{base}[] x")) for base in _RANGES}


def genuine_class(name: str, **fields: str) -> type[Any]:
    """Return a class that looks like one of a genuine ROS 2."""
    attributes: dict[str, Any] = {
        "__module__": f"std_msgs.msg._{name.lower()}",
        "get_fields_and_field_types": classmethod(lambda _: fields),
    }
    return type(name, (), attributes)


def test_a_message_of_a_genuine_class_is_stored_as_it_is() -> None:
    header = genuine_class("Header", stamp="builtin_interfaces/Time", frame_id="string")()
    message: Any = get_message("geometry_msgs/msg/PoseStamped")(header=header)
    assert message.header is header
    message.header = header
    listed = define("std_msgs/Header[] headers")(headers=[header, get_message("std_msgs/Header")()])
    assert listed.headers[0] is header


@pytest.mark.parametrize(
    "other", [genuine_class("Header", stamp="double"), genuine_class("Empty"), genuine_class("Ab")]
)
def test_a_message_of_a_genuine_class_of_another_type_is_refused(other: type[Any]) -> None:
    with pytest.raises(FieldTypeError, match="must be a std_msgs/msg/Header"):
        get_message("geometry_msgs/msg/PoseStamped")(header=other())
