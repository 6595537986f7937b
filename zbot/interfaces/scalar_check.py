"""Checks of single values. A check converts a value without loss, or rejects the value.

The checks are the slow path. A generated class tests the exact type inline, and calls a check only
if this test fails.
"""

from __future__ import annotations

import math
import numbers
import operator
from typing import Any

from zbot.interfaces.errors import FieldTypeError, FieldValueError
from zbot.interfaces.message import call_text
from zbot.interfaces.same_type import is_same_type
from zbot.interfaces.spec import FLOAT32_MAX, INTEGER_RANGES, FieldType


class ScalarCheck:
    """Check of one value of a type, called with the field's label and the value."""

    expected: str  #: text after "must be" in the error message

    def __init__(self, type_name: str, expected: str) -> None:
        self.type_name, self.expected = type_name, expected

    def __call__(self, label: str, value: Any) -> Any:
        """Return the value to store, or raise `FieldTypeError` or `FieldValueError`."""
        raise NotImplementedError

    def fits(self, values: list[Any]) -> bool:
        """Return True if all values can be stored unchanged. Else the caller checks each value."""
        return not values

    def wrong_type(self, label: str, value: object) -> FieldTypeError:
        """Return the error for a value of another type."""
        return FieldTypeError(self.type_name, label, self.expected, value)

    def wrong_value(self, label: str, value: object) -> FieldValueError:
        """Return the error for a number that is out of range, or a value of a wrong length."""
        return FieldValueError(self.type_name, label, self.expected, value)


class _BoolCheck(ScalarCheck):
    """Check of a bool. numpy's bools are accepted, and numbers are rejected."""

    def __init__(self, type_name: str) -> None:
        super().__init__(type_name, "a bool")

    def __call__(self, label: str, value: Any) -> bool:
        if isinstance(value, bool) or _is_numpy_bool(value):
            return bool(value)
        raise self.wrong_type(label, value)

    def fits(self, values: list[Any]) -> bool:
        return set(map(type, values)) <= {bool}


class _IntegerCheck(ScalarCheck):
    """Check of an integer in a range. Enum members, numpy's integers and True (1) are accepted."""

    def __init__(self, type_name: str, base: str) -> None:
        self.low, self.high = INTEGER_RANGES[base]
        super().__init__(type_name, f"an int from {self.low} to {self.high}")

    def __call__(self, label: str, value: Any) -> int:
        if not isinstance(value, numbers.Integral):
            raise self.wrong_type(label, value)
        number = int(operator.index(value))
        if not self.low <= number <= self.high:
            raise self.wrong_value(label, value)
        return number


class _FloatCheck(ScalarCheck):
    """Check of a float. An int is converted, `inf` and `nan` are allowed, a bool is rejected."""

    def __init__(self, type_name: str, base: str) -> None:
        self.is_single = base == "float32"
        super().__init__(
            type_name, "a float within float32's range" if self.is_single else "a float"
        )

    def __call__(self, label: str, value: Any) -> float:
        # The first test is only for speed, because most values here are ints.
        if value.__class__ is not int and not _is_real(value):
            raise self.wrong_type(label, value)
        try:
            number = float(value)
        except OverflowError as error:
            raise self.wrong_value(label, value) from error
        if self.is_single and abs(number) > FLOAT32_MAX and math.isfinite(number):
            raise self.wrong_value(label, value)
        return number


class _StringCheck(ScalarCheck):
    """Check of a string that UTF-8 can encode. The bound is in characters. 0 means no bound.

    A `TypeHash` is converted, because rclpy programs put it into requests for a type's description.
    """

    def __init__(self, type_name: str, bound: int) -> None:
        self.bound = bound
        super().__init__(type_name, f"a str of at most {bound} characters" if bound else "a str")

    def __call__(self, label: str, value: Any) -> str:
        if not isinstance(value, str):
            if getattr(value, "_zbot_stands_for", None) != "string":
                raise self.wrong_type(label, value)
            value = str(value)
        if self.bound and len(value) > self.bound:
            raise self.wrong_value(label, value)
        try:
            value.encode()
        except UnicodeEncodeError as error:
            expected = "text that UTF-8 can encode (it has a lone surrogate)"
            raise FieldValueError(self.type_name, label, expected, value) from error
        return str.__str__(value)

    def fits(self, values: list[Any]) -> bool:
        return not self.bound and set(map(type, values)) <= {str} and all(map(str.isascii, values))


class _ByteCheck(ScalarCheck):
    """Check of one byte, which is `bytes` of length 1 in ROS 2's Python."""

    def __init__(self, type_name: str) -> None:
        super().__init__(type_name, "bytes of length 1 such as b'\\x00'")

    def __call__(self, label: str, value: Any) -> bytes:
        if not isinstance(value, (bytes, bytearray)):
            raise self.wrong_type(label, value)
        if len(value) != 1:
            raise self.wrong_value(label, value)
        return bytes(value)


class _MessageCheck(ScalarCheck):
    """Check of a message of one class or a subclass, or of an object used in its place.

    This object is a message of the same type whose class an installed ROS 2 has made, or a
    `zbot.Parameter`. rclpy programs put it into a `ParameterEvent` that is not sent.
    """

    def __init__(self, type_name: str, cls: type[Any], cls_name: str) -> None:
        self.cls, self.cls_name = cls, cls_name
        self._twins: set[type[Any]] = set()  #: other classes of the same type
        super().__init__(type_name, f"a {cls_name}")

    def __call__(self, label: str, value: Any) -> Any:
        if isinstance(value, self.cls) or type(value) in self._twins:
            return value
        if is_same_type(type(value), self.cls):
            self._twins.add(type(value))
        elif getattr(value, "_zbot_stands_for", None) != self.cls_name:
            raise self.wrong_type(label, value)
        return value

    def wrong_type(self, label: str, value: object) -> FieldTypeError:
        hint = f"; write {call_text(self.cls)}"
        return FieldTypeError(self.type_name, label, self.expected, value, hint)

    def fits(self, values: list[Any]) -> bool:
        return set(map(type, values)) <= {self.cls}


def scalar_check(type_name: str, field_type: FieldType, cls: type[Any] | None) -> ScalarCheck:
    """Return the check for one value of a field's base type.

    Args:
        type_name: The message that has the field. Error messages contain this name.
        field_type: The field's type. For an array, the check is for the elements.
        cls: Class of the values if they are messages.
    """
    if cls is not None:
        return _MessageCheck(type_name, cls, field_type.base)
    base = field_type.base
    if base == "bool":
        return _BoolCheck(type_name)
    if base == "byte":
        return _ByteCheck(type_name)
    if base in INTEGER_RANGES:
        return _IntegerCheck(type_name, base)
    if field_type.is_string:
        return _StringCheck(type_name, field_type.string_bound)
    return _FloatCheck(type_name, base)


def _is_real(value: object) -> bool:
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


def _is_numpy_bool(value: object) -> bool:
    cls = type(value)
    return cls.__module__ == "numpy" and cls.__name__ in {"bool", "bool_"}
