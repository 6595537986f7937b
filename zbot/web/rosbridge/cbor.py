"""CBOR (RFC 8949) of messages. Arrays of numbers are typed arrays (RFC 8746), little-endian."""

from __future__ import annotations

import array
import struct
import sys
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import fields_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from zbot.interfaces import FieldType

_UNSIGNED, _NEGATIVE, _BYTES, _TEXT, _LIST, _MAP, _TAG = range(7)
_SIMPLE = {False: b"\xf4", True: b"\xf5", None: b"\xf6"}
#: Tag of the typed array for each typecode of Python's `array`.
_TAGS = {"H": 69, "I": 70, "Q": 71, "b": 72, "h": 77, "i": 78, "q": 79, "f": 85, "d": 86}


class TypedArray:
    """Numbers that CBOR stores as one block of bytes.

    Args:
        typecode: The typecode of Python's `array`.
        values: The numbers.
    """

    def __init__(self, typecode: str, values: Any) -> None:
        self.tag = _TAGS[typecode]
        numbers = array.array(typecode, values)
        if sys.byteorder == "big":
            numbers.byteswap()
        self.block = numbers.tobytes()


def cbor_value(message: Any) -> dict[str, Any]:
    """Return a message as a dictionary for `encode`."""
    return {
        field.name: _field_value(getattr(message, field.name), field.type)
        for field in fields_of(message)
    }


def _field_value(value: Any, kind: FieldType) -> Any:
    if kind.kind == "scalar":
        return cbor_value(value) if kind.is_message else _scalar(value)
    if kind.is_message:
        return [cbor_value(one) for one in value]
    if kind.base == "byte":
        return b"".join(value)
    if kind.typecode == "B":
        return value.tobytes() if hasattr(value, "tobytes") else bytes(value)
    if kind.typecode:
        return TypedArray(kind.typecode, value)
    return [_scalar(one) for one in value]


def _scalar(value: Any) -> Any:
    if isinstance(value, bytes):
        return value[0]  # a field of the type byte
    return value.item() if hasattr(value, "item") else value


def encode(value: Any) -> bytes:
    """Return the CBOR of a value made of dictionaries, lists, scalars, bytes and `TypedArray`.

    Raises:
        TypeError: The value contains an object of another type.
    """
    return b"".join(_parts(value))


def _parts(value: Any) -> Iterator[bytes]:
    if isinstance(value, dict):
        yield _head(_MAP, len(value))
        for key, item in value.items():
            yield from _parts(key)
            yield from _parts(item)
    elif isinstance(value, list):
        yield _head(_LIST, len(value))
        for item in value:
            yield from _parts(item)
    elif isinstance(value, TypedArray):
        yield _head(_TAG, value.tag) + _head(_BYTES, len(value.block))
        yield value.block
    else:
        yield _scalar_part(value)


def _scalar_part(value: Any) -> bytes:
    if value is None or isinstance(value, bool):
        return _SIMPLE[value]
    if isinstance(value, int):
        return _head(_UNSIGNED, value) if value >= 0 else _head(_NEGATIVE, -1 - value)
    if isinstance(value, float):
        return b"\xfb" + struct.pack(">d", value)
    if isinstance(value, str):
        text = value.encode()
        return _head(_TEXT, len(text)) + text
    if isinstance(value, bytes):
        return _head(_BYTES, len(value)) + value
    raise TypeError(f"CBOR has no form for {type(value).__name__}")


def _head(major: int, number: int) -> bytes:
    kind = major << 5
    if number < 24:
        return bytes([kind | number])
    for code, layout in ((24, ">BB"), (25, ">BH"), (26, ">BI"), (27, ">BQ")):
        if number < 1 << (8 * (struct.calcsize(layout) - 1)):
            return struct.pack(layout, kind | code, number)
    raise TypeError(f"CBOR has no form for the integer {number}")
