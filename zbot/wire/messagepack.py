"""MessagePack itself: values to bytes and back, with numeric arrays as extensions.

An array of numbers is an extension whose code is the ASCII code of its `array` typecode and whose
data are the elements, little-endian, in their standard size.
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
#: bytes of one element, for each typecode of a numeric array
ITEM_SIZE = {typecode: calcsize(f"={typecode}") for typecode in "bBhHiIqQfd"}

# Any list may claim its length before its elements are seen, so a thousand nested claims would cost
# memory that nothing stands for. Lists longer than this are counted first.
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

# One packer serves every type and thread: pack() is a single call into C that keeps no state.
pack: Callable[[Any], bytes] = msgpack.Packer(use_bin_type=True).pack
_unpackb: Callable[..., Any] = msgpack.unpackb


class UnreadableError(Exception):
    """The bytes are no MessagePack, or more than a message can be."""


class Extension(NamedTuple):
    """An extension that is no numeric array, so no field accepts it."""

    code: int
    data: bytes


def unpack(data: Bytes) -> Any:
    """Return the value that bytes stand for; an array extension as `array.array`.

    Memory stays in proportion to the bytes that arrived.

    Raises:
        UnreadableError: They stand for none.
    """
    try:
        return _unpackb(data, ext_hook=_read_ext, strict_map_key=True, max_array_len=_SHORT_LIST)
    except (ValueError, TypeError, MemoryError) as error:
        if "max_array_len" not in str(error):
            raise UnreadableError(_reason(error)) from error
    return _unpack_long(data)


def extension(code: int, values: array[Any]) -> Any:
    """Return a numeric array as an extension to pack."""
    # ExtType's own constructor checks its arguments once more, which takes longer than the rest.
    return tuple.__new__(msgpack.ExtType, (code, values.tobytes()))


def map_header(count: int) -> bytes:
    """Return the header of a map with `count` entries, at most 65535."""
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
    """Return the array of an extension's data, or None if they are not whole elements of one."""
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


def _unpack_long(data: Bytes) -> Any:
    """Unpack what has long lists, after walking through it once without making a single object."""
    walker = msgpack.Unpacker(max_buffer_size=len(data), strict_map_key=True)
    try:
        walker.feed(data)
        walker.skip()
        return _unpackb(data, ext_hook=_read_ext, strict_map_key=True)
    except (ValueError, TypeError, MemoryError, msgpack.OutOfData) as error:
        raise UnreadableError(_reason(error)) from error


def _reason(error: Exception) -> str:
    for kind, reason in _REASONS.items():
        if isinstance(error, kind):
            return reason
    return f"this is no MessagePack: {error}"
