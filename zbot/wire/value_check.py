"""What generated codecs call when a value is not plainly right: convert it, or say what is wrong.

A generated function tests each value inline and comes here only where the test fails; so nothing
below is on the fast path of a well-formed message.
"""

from __future__ import annotations

import math
from array import array
from struct import calcsize
from typing import TYPE_CHECKING, Any

from zbot.interfaces.spec import FLOAT32_MAX
from zbot.wire.messagepack import BIG_ENDIAN, ITEM_SIZE, Extension

if TYPE_CHECKING:
    from collections.abc import Callable

#: stands for a field that the sender left out
MISSING: Any = object()


def _same_numbers(typecode: str) -> set[str]:
    families = ("bhilq", "BHILQ", "f", "d")
    family = next(family for family in families if typecode in family)
    return {code for code in family if calcsize(code) == ITEM_SIZE[typecode]}


# The formats that a buffer of each typecode may have: numpy writes "l" where array writes "q".
_FORMATS = {typecode: _same_numbers(typecode) for typecode in ITEM_SIZE}


class Fault(Exception):  # noqa: N818 - never leaves the codec, which turns it into a CodecError
    """One field's value is wrong; the path grows on its way out of nested messages."""

    def __init__(self, field: str, reason: str) -> None:
        super().__init__(reason)
        self.path, self.reason = field, reason

    def inside(self, field: str) -> Fault:
        """Return the same fault as seen from the message around it."""
        self.path = f"{field}.{self.path}" if self.path else field
        return self


def kind(value: Any) -> str:
    """Return what a value is, for a sentence: short, whatever its size."""
    if isinstance(value, Extension):
        return f"an extension with code {value.code}"
    text = repr(value) if isinstance(value, (bool, int, float, str, bytes, type(None))) else ""
    name = type(value).__name__
    return f"{name} {text[:40]}{'...' if len(text) > 40 else ''}" if text else name


def wrong(field: str, expected: str, value: Any) -> Fault:
    """Return the fault of a value that is something else than it must be."""
    return Fault(field, f"expected {expected}, not {kind(value)}")


def message_fault(field: str, type_name: str, value: Any, error: Exception) -> Fault:
    """Return the fault of a nested message as seen from the message around it."""
    if isinstance(error, Fault):
        return error.inside(field)
    return wrong(field, f"a {type_name}", value)


def items_fault(
    field: str, type_name: str, values: list[Any], convert: Callable[[Any], Any]
) -> Fault:
    """Return the fault of the first message in a list that `convert` refuses."""
    for index, value in enumerate(values):
        try:
            convert(value)
        except (Fault, AttributeError) as error:
            return message_fault(f"{field}[{index}]", type_name, value, error)
    return Fault(field, "the list changed while it was read")


def boolean(field: str, value: Any) -> bool:
    """Return a bool's value; numpy's own bool counts."""
    if type(value).__name__ in {"bool_", "bool"}:
        return bool(value)
    raise wrong(field, "a bool", value)


def integer(field: str, value: Any, low: int, high: int) -> int:
    """Return an integer within its type's range."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise wrong(field, "an integer", value)
    number = int(value)
    if not low <= number <= high:
        raise Fault(field, f"{kind(number)} is not in the range {low} to {high}")
    return number


def real(field: str, value: Any) -> float:
    """Return a float; an integer is widened."""
    if isinstance(value, bool) or not isinstance(value, (float, int)):
        raise wrong(field, "a number", value)
    try:
        return float(value)
    except OverflowError:
        raise Fault(field, "the integer is too large for a float") from None


def real32(field: str, value: Any) -> float:
    """Return a float that a float32 can hold, infinities and NaN among them."""
    number = real(field, value)
    if math.isfinite(number) and abs(number) > FLOAT32_MAX:
        raise Fault(field, f"{number} is out of range for a float32")
    return number


def text(field: str, value: Any, bound: int) -> str:
    """Return a string of at most `bound` characters; a bound of 0 is none."""
    if not isinstance(value, str):
        raise wrong(field, "a string", value)
    if bound and len(value) > bound:
        raise Fault(field, f"{len(value)} characters, at most {bound} are allowed")
    return str(value)


def octet(field: str, value: Any) -> int:
    """Return the number of a `byte`, which Python holds as `bytes` of length 1."""
    if isinstance(value, bytes) and len(value) == 1:
        return value[0]
    raise wrong(field, "one byte", value)


def octet_from(field: str, value: Any) -> bytes:
    """Return a received `byte`; one as bytes is accepted too."""
    if isinstance(value, bytes):
        value = octet(field, value)
    return bytes((integer(field, value, 0, 255),))


def length(field: str, count: int, size: int, *, fixed: bool) -> None:
    """Refuse a sequence that has not the length its type asks for; a bound of 0 is none."""
    if fixed and count != size:
        raise Fault(field, f"{count} elements, exactly {size} are needed")
    if size and count > size:
        raise Fault(field, f"{count} elements, at most {size} are allowed")


def items(field: str, value: Any, size: int, *, fixed: bool) -> list[Any]:
    """Return a list of the right length."""
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
    """Return a list of `byte` as one binary."""
    values = items(field, value, size, fixed=fixed)
    return bytes(octet(f"{field}[{index}]", item) for index, item in enumerate(values))


def octets_from(field: str, value: Any, size: int, *, fixed: bool) -> list[bytes]:
    """Return received `byte` elements: a binary, or a list."""
    if isinstance(value, bytes):
        length(field, len(value), size, fixed=fixed)
        return [bytes((number,)) for number in value]
    values = items(field, value, size, fixed=fixed)
    return [octet_from(f"{field}[{index}]", item) for index, item in enumerate(values)]


def numbers(field: str, value: Any, typecode: str, size: int, *, fixed: bool) -> array[Any]:
    """Return a numeric array as the wire has it: of one typecode, little-endian, without gaps."""
    try:
        view = memoryview(value)
    except TypeError:
        return _little_endian(_listed(field, value, typecode, size, fixed=fixed))
    if view.ndim != 1 or view.format.lstrip("@=") not in _FORMATS[typecode]:
        raise wrong(field, f"an array of typecode {typecode!r}", value)
    length(field, len(view), size, fixed=fixed)
    return _little_endian(array(typecode, view.tobytes()))


def numbers_from(field: str, value: Any, typecode: str, size: int, *, fixed: bool) -> array[Any]:
    """Return received elements: an extension (already an array), a binary or a list."""
    if isinstance(value, bytes) and typecode == "B":
        value = array("B", value)
    if not isinstance(value, array):
        return _listed(field, value, typecode, size, fixed=fixed)
    if value.typecode != typecode:
        expected = f"an array of typecode {typecode!r}"
        raise Fault(field, f"expected {expected}, not one of {value.typecode!r}")
    length(field, len(value), size, fixed=fixed)
    return value


def _little_endian(values: array[Any]) -> array[Any]:
    if BIG_ENDIAN:
        values.byteswap()
    return values


def _listed(field: str, value: Any, typecode: str, size: int, *, fixed: bool) -> array[Any]:
    values = items(field, value, size, fixed=fixed)
    check = {"f": real32, "d": real}.get(typecode) or _integer_check(typecode)
    return array(typecode, [check(f"{field}[{i}]", item) for i, item in enumerate(values)])


def _integer_check(typecode: str) -> Callable[[str, Any], int]:
    bits = 8 * ITEM_SIZE[typecode]
    low = 0 if typecode.isupper() else -(2 ** (bits - 1))
    high = low + 2**bits - 1
    return lambda field, value: integer(field, value, low, high)
