"""Checks of the values of fields, for single values, arrays and sequences.

A generated class first makes a quick test of its own. It calls these checks only for a value that
fails this test.
"""

from __future__ import annotations

import math
import operator
from array import array
from collections.abc import Collection, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from zbot.interfaces.array_value import DTYPES, fixed_array, is_ndarray, numpy
from zbot.interfaces.errors import FieldTypeError, FieldValueError
from zbot.interfaces.scalar_check import ScalarCheck, scalar_check

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import FieldType


#: Iterable types that are rejected for numbers.
_NO_NUMBERS = (str, bytes, bytearray, Mapping)


class _ListCheck:
    """Check of lists of bools, bytes, strings or messages. A valid list is stored, not a copy."""

    def __init__(self, field_type: FieldType, element: ScalarCheck) -> None:
        self.field_type, self.element = field_type, element
        self.type_name = element.type_name
        self.expected = f"a list{_length_text(field_type)}, of which each is {element.expected}"

    def __call__(self, label: str, value: Any) -> list[Any]:
        values = value if value.__class__ is list else self._as_list(label, value)
        if not _has_good_length(self.field_type, len(values)):
            raise FieldValueError(self.type_name, label, self.expected, value)
        if self.element.fits(values):
            return values
        checked = [self.element(f"{label}[{i}]", each) for i, each in enumerate(values)]
        return values if all(map(operator.is_, checked, values)) else checked

    def _as_list(self, label: str, value: Any) -> list[Any]:
        if not _is_collection(value):
            raise FieldTypeError(self.type_name, label, self.expected, value)
        return value.tolist() if is_ndarray(value) else list(value)


class _NumberSequenceCheck:
    """Check of number sequences, stored as `array.array`. A valid array is stored, not a copy."""

    def __init__(self, field_type: FieldType, element: ScalarCheck) -> None:
        self.field_type, self.element = field_type, element
        self.type_name, self.typecode = element.type_name, field_type.typecode
        self.is_float = self.typecode in "fd"
        self.exact = {int, float} if self.is_float else {int}
        self.expected = f"a list{_length_text(field_type)}, of which each is {element.expected}"

    def __call__(self, label: str, value: Any) -> Any:
        numbers = self._as_array(label, value)
        if not _has_good_length(self.field_type, len(numbers)):
            raise FieldValueError(self.type_name, label, self.expected, value)
        return numbers

    def _as_array(self, label: str, value: Any) -> array[Any]:
        if isinstance(value, array) and value.typecode == self.typecode:
            return value
        if self.typecode in "bB" and isinstance(value, (bytes, bytearray, memoryview)):
            return _from_bytes(self.typecode, value)
        if is_ndarray(value):
            return self._from_ndarray(label, value)
        if isinstance(value, _NO_NUMBERS) or not isinstance(value, Iterable):
            raise FieldTypeError(self.type_name, label, self.expected, value)
        return self._from_values(label, list(value))

    def _from_values(self, label: str, values: list[Any]) -> array[Any]:
        if set(map(type, values)) <= self.exact:
            try:
                numbers = array(self.typecode, values)
            except OverflowError:
                pass  # the loop below finds the element that is too large
            else:
                if self.typecode != "f" or _infinities(numbers) == _infinities(values):
                    return numbers
        checked = [self.element(f"{label}[{i}]", each) for i, each in enumerate(values)]
        return array(self.typecode, checked)

    def _from_ndarray(self, label: str, value: Any) -> array[Any]:
        if value.ndim != 1:
            expected = f"flat (use .ravel()): {self.expected}"
            raise FieldValueError(self.type_name, label, expected, value)
        kind = value.dtype.kind
        if kind not in ("fiu" if self.is_float else "iu"):
            raise FieldTypeError(self.type_name, label, self.expected, value)
        module: Any = numpy()
        with module.errstate(over="ignore"):
            converted = module.ascontiguousarray(value, DTYPES[self.typecode])
        if self._has_changed(value, converted):
            return self._from_values(label, value.tolist())  # finds the element that does not fit
        return _from_bytes(self.typecode, converted.tobytes())

    def _has_changed(self, value: Any, converted: Any) -> bool:
        """Return whether a value did not fit, i.e. an int overflowed or a float became infinite."""
        module: Any = numpy()
        if self.typecode == "d" or value.dtype == converted.dtype:
            return False
        if self.is_float:
            return bool((module.isinf(value) != module.isinf(converted)).any())
        # This compares Python ints, because numpy compares int64 with uint64 as floats.
        return value.size > 0 and (
            int(value.min()) != int(converted.min()) or int(value.max()) != int(converted.max())
        )


class _FixedNumbersCheck(_NumberSequenceCheck):
    """Check of fixed-size number arrays. With numpy, the stored value is an ndarray."""

    def __call__(self, label: str, value: Any) -> Any:
        size = self.field_type.size
        if (
            is_ndarray(value)
            and value.shape == (size,)
            and value.dtype == DTYPES[self.typecode]
            and value.flags.c_contiguous
        ):
            return value
        return fixed_array(self.typecode, super().__call__(label, value))


def field_check(
    type_name: str, field_type: FieldType, cls: type[Any] | None
) -> Callable[[str, Any], Any]:
    """Return a function that takes a field's label and a value and returns the value to store.

    Args:
        type_name: The message that has the field. Error messages contain this name.
        field_type: The field's type.
        cls: Class of the values if they are messages.
    """
    element = scalar_check(type_name, field_type, cls)
    if field_type.kind == "scalar":
        return element
    if not field_type.typecode:
        return _ListCheck(field_type, element)
    if field_type.kind == "array":
        return _FixedNumbersCheck(field_type, element)
    return _NumberSequenceCheck(field_type, element)


def _from_bytes(typecode: str, data: bytes | bytearray | memoryview) -> array[Any]:
    numbers: array[Any] = array(typecode)
    numbers.frombytes(data)
    return numbers


def _infinities(numbers: array[float] | list[float]) -> int:
    """Return the number of infinities. array('f') makes large numbers infinite without an error."""
    return numbers.count(math.inf) + numbers.count(-math.inf)


def _is_collection(value: object) -> bool:
    if isinstance(value, (str, bytes, bytearray, memoryview, Mapping)):
        return False
    return isinstance(value, Collection)


def _has_good_length(field_type: FieldType, length: int) -> bool:
    if field_type.kind == "array":
        return length == field_type.size
    return not field_type.size or length <= field_type.size


def _length_text(field_type: FieldType) -> str:
    if field_type.kind == "array":
        return f" of {field_type.size} values"
    return f" of at most {field_type.size} values" if field_type.size else ""
