"""Conversions of single values for the generated CDR codecs."""

from __future__ import annotations

from array import array
from struct import Struct, error, pack, unpack
from typing import Any

from zbot.wire.cdr.alignment import UNIT_SIZE
from zbot.wire.validation import Fault

FOUR_ZEROS = bytes(4)
#: reason of a `Fault`
TOO_LONG = "a sequence is longer than the bytes that follow"

_count = Struct("<I").pack
_SHORT_COUNTS = [_count(size + 1) for size in range(256)]
#: NUL and padding after a text. The index is the number of bytes of the text modulo 4.
_ENDS = (b"\0\0\0\0", b"\0\0\0", b"\0\0", b"\0")


def text_items(texts: list[str]) -> bytes:
    """Return the bytes of a sequence's texts. They begin after the count, at a multiple of 4."""
    parts: list[bytes] = []
    for text in texts:
        data = text.encode()
        size = len(data)
        count = _SHORT_COUNTS[size] if size < 256 else _count(size + 1)
        parts += count, data, _ENDS[size & 3]
    if parts:
        parts[-1] = b"\0"  # there is no padding after the last text
    return b"".join(parts)


def large(typecode: str, data: bytes, begin: int, end: int) -> array[Any]:
    """Return the numbers in a part of the bytes. The part is copied only once."""
    values: array[Any] = array(typecode)
    values.frombytes(memoryview(data)[begin:end])
    return values


def bool_items(field: str, data: bytes) -> list[bool]:
    """Return the bools in bytes of 0 and 1."""
    wrong = data.strip(b"\0\1")
    if wrong:
        raise Fault(field, f"{wrong[0]} is not a bool")
    return list(map(bool, data))


def any_bool_items(field: str, data: bytes) -> list[bool]:
    """Return the bools in bytes. Each byte that is not 0 is true."""
    del field  # any byte is valid
    return list(map(bool, data))


def byte_items(field: str, data: bytes) -> list[bytes]:
    """Return each byte as `bytes` of length 1."""
    del field  # any byte is valid
    return [data[index : index + 1] for index in range(len(data))]


def wide_units(text: str) -> bytes:
    """Return the UTF-16 units of a text, each as a number of four bytes."""
    data = text.encode("utf-16-le")
    if len(data) == 2 * len(text):  # each character is one unit
        return text.encode("utf-32-le")
    zeros = bytes(UNIT_SIZE - 2)
    return b"".join(data[begin : begin + 2] + zeros for begin in range(0, len(data), 2))


def any_wide_text(field: str, data: bytes, order: str) -> str:
    """Return the text of UTF-16 units. Units that are not valid become U+FFFD."""
    return wide_text(field, data, order, errors="replace")


def wide_text(field: str, data: bytes, order: str, errors: str = "strict") -> str:
    """Return the text of UTF-16 units. `order` is the byte order of the units, `<` or `>`."""
    units = unpack(f"{order}{len(data) // UNIT_SIZE}I", data)
    try:
        return pack(f"<{len(units)}H", *units).decode("utf-16-le", errors)
    except (error, UnicodeDecodeError):
        raise Fault(field, "a wide text is not valid UTF-16") from None
