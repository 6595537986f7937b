"""Reader of large numeric arrays in a message's MessagePack map. It copies each array only once.

`msgpack.unpackb` copies a binary into `bytes`, so the array would need a second copy. The reader
here scans the top level of the map, copies each array into an `array.array`, and leaves the other
entries as a small map for msgpack. If the bytes have an unexpected form, the reader returns None.
Then msgpack reads all bytes and reports the error.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from zbot.wire.messagepack.packing import Bytes, map_header, read_array

if TYPE_CHECKING:
    from array import array

#: size in bytes below which msgpack alone is faster
LARGE = 1 << 16
# A message with large arrays has few other values. For many values, the scan would be too slow.
_MAX_STEPS = 500

# _FIXED: tags of values with a fixed size, and the number of bytes after the tag.
# _SIZED: other tags, the number of bytes of the size, and that of the extension code.
_FIXED = dict.fromkeys([*range(0x80), *range(0xE0, 0x100), 0xC0, 0xC2, 0xC3], 0)
_FIXED |= {0xCA: 4, 0xCB: 8, 0xCC: 1, 0xCD: 2, 0xCE: 4, 0xCF: 8, 0xD0: 1, 0xD1: 2, 0xD2: 4}
_FIXED |= {0xD3: 8, 0xD4: 2, 0xD5: 3, 0xD6: 5, 0xD7: 9, 0xD8: 17}
_FIXED |= {0xA0 | length: length for length in range(32)}
_SIZED = {0xC4: (1, 0), 0xC5: (2, 0), 0xC6: (4, 0), 0xC7: (1, 1), 0xC8: (2, 1), 0xC9: (4, 1)}
_SIZED |= {0xD9: (1, 0), 0xDA: (2, 0), 0xDB: (4, 0)}
_BIN32, _EXT32 = 0xC6, 0xC9


def extract_arrays(
    data: Bytes, names: dict[bytes, str]
) -> tuple[bytes, dict[str, array[Any]]] | None:
    """Return the map's bytes without the large arrays, and a dictionary of the arrays by name.

    Args:
        data: A message's bytes.
        names: Names of the fields that are numeric arrays. The keys are the packed names.
    """
    view = memoryview(data).cast("B")
    try:
        count, position = _map_header(view)
        arrays: dict[str, array[Any]] = {}
        kept: list[bytes | memoryview] = []
        for _ in range(count):
            key_end = _end(view, position)
            end = _end(view, key_end)
            name = names.get(bytes(view[position:key_end]))
            values = _array(view, key_end, end) if name else None
            if name is None or values is None:
                kept.append(view[position:end])
            else:
                arrays[name] = values
            position = end
    except (_UnexpectedBytesError, IndexError):
        return None
    if position != len(view):
        return None
    return b"".join((map_header(len(kept)), *kept)), arrays


class _UnexpectedBytesError(Exception):
    """The bytes do not have the form of a message with large arrays."""


def _map_header(view: memoryview) -> tuple[int, int]:
    tag = view[0]
    if tag & 0xF0 == 0x80:
        return tag & 0x0F, 1
    if tag == 0xDE:
        return int.from_bytes(view[1:3], "big"), 3
    raise _UnexpectedBytesError


def _end(view: memoryview, position: int) -> int:
    """Return the position after the value that begins at `position`."""
    remaining = 1
    for _ in range(_MAX_STEPS):
        tag = view[position]
        if tag in _FIXED:
            position += 1 + _FIXED[tag]
        elif tag in _SIZED:
            width, extra = _SIZED[tag]
            size = int.from_bytes(view[position + 1 : position + 1 + width], "big")
            position += 1 + width + extra + size
        elif tag & 0xF0 == 0x80:
            position, remaining = position + 1, remaining + 2 * (tag & 0x0F)
        elif tag & 0xF0 == 0x90:
            position, remaining = position + 1, remaining + (tag & 0x0F)
        else:  # a long list or map, or an invalid tag
            raise _UnexpectedBytesError
        remaining -= 1
        if remaining == 0:
            if position > len(view):
                raise _UnexpectedBytesError
            return position
    raise _UnexpectedBytesError


def _array(view: memoryview, start: int, end: int) -> array[Any] | None:
    """Return the array between two positions. Return None if it is not a large valid array."""
    tag = view[start]
    if tag == _BIN32:
        typecode, begin = "B", start + 5
    elif tag == _EXT32:
        typecode, begin = chr(view[start + 5]), start + 6
    else:
        return None
    return read_array(typecode, view[begin:end])
