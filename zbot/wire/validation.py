"""Checks and conversions of single values. Each function returns the value or raises `Fault`.

A generated codec tests most values inline, so the speed of this module matters little.
"""

from __future__ import annotations

import math
from array import array
from contextlib import suppress
from struct import calcsize
from struct import error as struct_error
from typing import TYPE_CHECKING, Any

from zbot.interfaces.spec import FLOAT32_MAX, INTEGER_RANGES
from zbot.wire.messagepack.packing import BIG_ENDIAN, ITEM_SIZE, Extension

if TYPE_CHECKING:
    from collections.abc import Callable

    from zbot.interfaces.spec import FieldType


def _same_numbers(typecode: str) -> set[str]:
    families = ("bhilq", "BHILQ", "f", "d")
    family = next(family for family in families if typecode in family)
    return {code for code in family if calcsize(code) == ITEM_SIZE[typecode]}


# For each typecode, the buffer formats that mean the same. E.g. numpy has "l" where array has "q".
_FORMATS = {typecode: _same_numbers(typecode) for typecode in ITEM_SIZE}


class Fault(Exception):  # noqa: N818 - internal: the codec turns it into a CodecError
    """A field's value is wrong. Each enclosing message adds its own field's name to the path."""

    def __init__(self, field: str, reason: str) -> None:
        super().__init__(reason)
        self.path, self.reason = field, reason

    def inside(self, field: str) -> Fault:
        """Return this fault with the enclosing message's field at the start of the path."""
        self.path = f"{field}.{self.path}" if self.path else field
        return self


class UnusualError(Exception):
    """A message has an unusual value or form. The walker converts or rejects it."""


#: What generated code raises for an unusual message, before other code does the work carefully.
UNUSUAL_ERRORS = (
    Fault,
    UnusualError,
    struct_error,
    AttributeError,
    LookupError,
    TypeError,
    ValueError,
    ArithmeticError,
    MemoryError,
    BufferError,
)


def kind(value: Any) -> str:
    """Return a short description of a value for an error message."""
    if isinstance(value, Extension):
        return f"an extension with code {value.code}"
    text = repr(value) if isinstance(value, (bool, int, float, str, bytes, type(None))) else ""
    name = type(value).__name__
    return f"{name} {text[:40]}{'...' if len(text) > 40 else ''}" if text else name


def wrong(field: str, expected: str, value: Any) -> Fault:
    """Return the fault for a value of the wrong type."""
    return Fault(field, f"expected {expected}, not {kind(value)}")


def scalar(kind: FieldType, field: str, value: Any) -> Any:
    """Return the value of a field that has one number, bool or text."""
    if kind.is_string:
        return text(field, value, kind.string_bound)
    if kind.base in INTEGER_RANGES:
        return integer(field, value, *INTEGER_RANGES[kind.base])
    return {"bool": boolean, "float32": real32, "float64": real}[kind.base](field, value)


def boolean(field: str, value: Any) -> bool:
    """Return a bool. A bool of numpy is converted."""
    if type(value).__name__ in {"bool_", "bool"}:
        return bool(value)
    raise wrong(field, "a bool", value)


def any_boolean(field: str, value: Any) -> bool:
    """Return a received bool. Each number that is not 0 is true."""
    return bool(value) if isinstance(value, int) else boolean(field, value)


def integer(field: str, value: Any, low: int, high: int) -> int:
    """Return an integer in the range of its type."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise wrong(field, "an integer", value)
    number = int(value)
    if not low <= number <= high:
        raise Fault(field, f"{kind(number)} is not in the range {low} to {high}")
    return number


def real(field: str, value: Any) -> float:
    """Return a float. An integer is converted."""
    if isinstance(value, bool) or not isinstance(value, (float, int)):
        raise wrong(field, "a number", value)
    try:
        return float(value)
    except OverflowError:
        raise Fault(field, "the integer is too large for a float") from None


def real32(field: str, value: Any) -> float:
    """Return a float that a float32 can hold. Infinities and NaN are allowed."""
    number = real(field, value)
    if math.isfinite(number) and abs(number) > FLOAT32_MAX:
        raise Fault(field, f"{number} is out of range for a float32")
    return number


def text(field: str, value: Any, bound: int) -> str:
    """Return a string of at most `bound` characters. A `bound` of 0 means no bound."""
    if not isinstance(value, str):
        raise wrong(field, "a string", value)
    if bound and len(value) > bound:
        raise Fault(field, f"{len(value)} characters, at most {bound} are allowed")
    return str(value)


def octet(field: str, value: Any) -> int:
    """Return a `byte` as a number. The Python value is `bytes` of length 1."""
    if isinstance(value, bytes) and len(value) == 1:
        return value[0]
    raise wrong(field, "one byte", value)


def octet_from(field: str, value: Any) -> bytes:
    """Return a received `byte`. The sender may send it as a number or as `bytes` of length 1."""
    if isinstance(value, bytes):
        value = octet(field, value)
    return bytes((integer(field, value, 0, 255),))


def length(field: str, count: int, size: int, *, fixed: bool) -> None:
    """Check the length of a sequence. A `size` of 0 means no bound."""
    if fixed and count != size:
        raise Fault(field, f"{count} elements, exactly {size} are needed")
    if size and count > size:
        raise Fault(field, f"{count} elements, at most {size} are allowed")


def items(field: str, value: Any, size: int, *, fixed: bool) -> list[Any]:
    """Check the length of a list or a tuple, and return the elements as a list."""
    if type(value) not in {list, tuple}:
        raise wrong(field, "a list", value)
    length(field, len(value), size, fixed=fixed)
    return list(value)


def booleans(field: str, value: Any, size: int, *, fixed: bool) -> list[bool]:
    """Return a list of bools."""
    values = items(field, value, size, fixed=fixed)
    if set(map(type, values)) <= {bool}:
        return values
    return [boolean(f"{field}[{index}]", item) for index, item in enumerate(values)]


def texts(field: str, value: Any, size: int, *, fixed: bool, bound: int) -> list[str]:
    """Return a list of strings, each of at most `bound` characters."""
    values = items(field, value, size, fixed=fixed)
    if not bound and set(map(type, values)) <= {str}:
        return values
    return [text(f"{field}[{index}]", item, bound) for index, item in enumerate(values)]


def octets(field: str, value: Any, size: int, *, fixed: bool) -> bytes:
    """Return a list of `byte` values as one binary of MessagePack."""
    values = items(field, value, size, fixed=fixed)
    if set(map(type, values)) <= {bytes} and set(map(len, values)) <= {1}:
        return b"".join(values)
    return bytes(octet(f"{field}[{index}]", item) for index, item in enumerate(values))


def numbers(field: str, value: Any, typecode: str, size: int, *, fixed: bool) -> array[Any]:
    """Return numbers as an `array.array` of this typecode, in little-endian order."""
    try:
        view = memoryview(value)
    except TypeError:
        return _little_endian(_listed(field, value, typecode, size, fixed=fixed))
    if view.ndim != 1 or view.format.lstrip("@=") not in _FORMATS[typecode]:
        raise wrong(field, f"an array of typecode {typecode!r}", value)
    length(field, len(view), size, fixed=fixed)
    return _little_endian(array(typecode, view.tobytes()))


def fixed_bytes(field: str, value: Any, typecode: str, size: int) -> bytes:
    """Return the bytes of a fixed-size array of numbers, in little-endian order."""
    try:
        # The usual value is an ndarray of the field's type. For it, `numbers` would be slow.
        dtype = value.dtype
        if dtype.char == typecode and dtype.isnative and value.shape == (size,) and not BIG_ENDIAN:
            data: bytes = value.tobytes()
            return data
    except AttributeError:
        pass  # an array.array or a list
    return numbers(field, value, typecode, size, fixed=True).tobytes()


def numbers_from(field: str, value: Any, typecode: str, size: int, *, fixed: bool) -> array[Any]:
    """Return received numbers. The sender may use an extension (an array), a binary or a list."""
    if isinstance(value, bytes) and typecode == "B":
        value = array("B", value)
    if not isinstance(value, array):
        return _listed(field, value, typecode, size, fixed=fixed)
    if value.typecode != typecode:
        expected = f"an array of typecode {typecode!r}"
        raise Fault(field, f"expected {expected}, not of typecode {value.typecode!r}")
    length(field, len(value), size, fixed=fixed)
    return value


def _little_endian(values: array[Any]) -> array[Any]:
    if BIG_ENDIAN:
        values.byteswap()
    return values


def _listed(field: str, value: Any, typecode: str, size: int, *, fixed: bool) -> array[Any]:
    values = items(field, value, size, fixed=fixed)
    if typecode != "f" and set(map(type, values)) <= {float if typecode == "d" else int}:
        with suppress(OverflowError):
            return array(typecode, values)
    check = {"f": real32, "d": real}.get(typecode) or _integer_check(typecode)
    return array(typecode, [check(f"{field}[{i}]", item) for i, item in enumerate(values)])


def _integer_check(typecode: str) -> Callable[[str, Any], int]:
    bits = 8 * ITEM_SIZE[typecode]
    low = 0 if typecode.isupper() else -(2 ** (bits - 1))
    high = low + 2**bits - 1
    return lambda field, value: integer(field, value, low, high)
