"""MessagePack encoder and decoder of plain values, with numeric arrays as extensions.

The extension's code is the ASCII code of the array's typecode. The extension's data are the
elements in little-endian order and in their standard size.
"""

from __future__ import annotations

import sys
from array import array
from struct import calcsize
from typing import TYPE_CHECKING, Any, NamedTuple

import msgpack  # type: ignore[import-untyped]

if TYPE_CHECKING:
    from collections.abc import Callable

Bytes = bytes | bytearray | memoryview

BIG_ENDIAN = sys.byteorder == "big"
#: size of one element in bytes, for each typecode of a numeric array
ITEM_SIZE = {typecode: calcsize(f"={typecode}") for typecode in "bBhHiIqQfd"}

# msgpack allocates a list from the length in its header. A thousand nested headers with wrong
# lengths would allocate too much memory, so a message with a list longer than this is
# validated first.
_SHORT_LIST = 1024
_FIXED_EXT = {1: 0xD4, 2: 0xD5, 4: 0xD6, 8: 0xD7, 16: 0xD8}
_REASONS: dict[type[Exception], str] = {
    UnicodeDecodeError: "a text is not valid UTF-8",
    MemoryError: "it is too large for this machine's memory",
    msgpack.OutOfData: "the bytes end before the message does",
    msgpack.StackError: "it is nested too deeply",
    msgpack.FormatError: "a byte has no meaning in MessagePack",
    msgpack.ExtraData: "more bytes follow the message",
}

# All types and threads can share one packer. pack() is one call into C, and keeps no state.
pack: Callable[[Any], bytes] = msgpack.Packer(use_bin_type=True).pack
_unpackb: Callable[..., Any] = msgpack.unpackb


class UnreadableError(Exception):
    """The bytes are not valid MessagePack, or are too large or nested too deeply."""


class Extension(NamedTuple):
    """An extension that is not a numeric array. No field accepts such an extension."""

    code: int
    data: bytes


def unpack(data: Bytes) -> Any:
    """Decode bytes and return the value. An array extension becomes an `array.array`.

    The memory use is proportional to the number of bytes.

    Raises:
        UnreadableError: The bytes are not valid.
    """
    try:
        return _unpackb(data, ext_hook=_read_ext, strict_map_key=True, max_array_len=_SHORT_LIST)
    except (ValueError, TypeError, MemoryError) as error:
        if "max_array_len" not in str(error):
            raise UnreadableError(_reason(error)) from error
    return _unpack_long(data)


def unpack_any_text(data: Bytes) -> Any:
    """Do the same as `unpack`, but bytes of a text that are not UTF-8 become U+FFFD."""
    return _unpack_long(data, "replace")


def extension(code: int, values: array[Any]) -> Any:
    """Return a numeric array as an extension for `pack`."""
    # ExtType's constructor would check its arguments. That would take longer than the
    # rest of this function.
    return tuple.__new__(msgpack.ExtType, (code, values.tobytes()))


def map_header(count: int) -> bytes:
    """Return the header of a map with `count` entries. A `count` above 65535 is not possible."""
    return bytes((0x80 | count,)) if count < 16 else b"\xde" + count.to_bytes(2, "big")


def bin_header(size: int) -> bytes:
    """Return the header of a binary of `size` bytes."""
    if size < 1 << 8:
        return b"\xc4%c" % size
    if size < 1 << 16:
        return b"\xc5" + size.to_bytes(2, "big")
    return b"\xc6" + size.to_bytes(4, "big")


def ext_header(code: int, size: int) -> bytes:
    """Return the header of an extension of `size` bytes."""
    if size < 1 << 8:
        fixed = _FIXED_EXT.get(size)
        return b"%c%c" % (fixed, code) if fixed else b"\xc7%c%c" % (size, code)
    if size < 1 << 16:
        return b"\xc8%b%c" % (size.to_bytes(2, "big"), code)
    return b"\xc9%b%c" % (size.to_bytes(4, "big"), code)


def read_array(typecode: str, data: bytes | memoryview) -> array[Any] | None:
    """Return the array in an extension's data. Return None if the typecode or the size is wrong."""
    if typecode not in ITEM_SIZE or len(data) % ITEM_SIZE[typecode]:
        return None
    values: array[Any] = array(typecode)
    values.frombytes(data)
    if BIG_ENDIAN:
        values.byteswap()
    return values


def _read_ext(code: int, data: bytes) -> Any:
    values = read_array(chr(code), data) if code > 0 else None
    return Extension(code, data) if values is None else values


def _unpack_long(data: Bytes, unicode_errors: str = "strict") -> Any:
    """Decode bytes with long lists. First validate the bytes without creating objects."""
    validator = msgpack.Unpacker(max_buffer_size=len(data), strict_map_key=True)
    try:
        validator.feed(data)
        validator.skip()
        return _unpackb(
            data, ext_hook=_read_ext, strict_map_key=True, unicode_errors=unicode_errors
        )
    except (ValueError, TypeError, MemoryError, msgpack.OutOfData) as error:
        raise UnreadableError(_reason(error)) from error


def _reason(error: Exception) -> str:
    for kind, reason in _REASONS.items():
        if isinstance(error, kind):
            return reason
    return f"the bytes are not MessagePack: {error}"
