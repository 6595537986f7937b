"""CBOR (RFC 8949) of messages. Arrays of numbers are typed arrays (RFC 8746), little-endian."""

from __future__ import annotations

import array
import sys
from typing import TYPE_CHECKING, Any

from zbot.interfaces.field_path import fields_of

if TYPE_CHECKING:
    from zbot.interfaces import FieldType

#: Tag of the typed array for each typecode of Python's `array`.
_TAGS = {"H": 69, "I": 70, "Q": 71, "b": 72, "h": 77, "i": 78, "q": 79, "f": 85, "d": 86}


def typed_array(typecode: str, values: Any) -> Any:
    """Return numbers that CBOR stores as one block of bytes.

    Args:
        typecode: The typecode of Python's `array`.
        values: The numbers.
    """
    import cbor2  # noqa: PLC0415 - few clients want CBOR

    numbers = array.array(typecode, values)
    if sys.byteorder == "big":
        numbers.byteswap()
    return cbor2.CBORTag(_TAGS[typecode], numbers.tobytes())


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
        return typed_array(kind.typecode, value)
    return [_scalar(one) for one in value]


def _scalar(value: Any) -> Any:
    if isinstance(value, bytes):
        return value[0]  # a field of the type byte
    return value.item() if hasattr(value, "item") else value


def encode(value: Any) -> bytes:
    """Return the CBOR of a value made of dictionaries, lists, scalars, bytes and typed arrays."""
    import cbor2  # noqa: PLC0415 - few clients want CBOR

    return cbor2.dumps(value)
