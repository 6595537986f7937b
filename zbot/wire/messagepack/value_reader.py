"""Readers of single values of MessagePack, for the generated decoders.

Each reader returns a value and the position after it. It raises `UnusualError`, or an error of
Python, if the bytes are not the value that zbot would send.
"""

from __future__ import annotations

from array import array
from itertools import islice
from typing import Any

import msgpack  # type: ignore[import-untyped]

from zbot.wire.validation import UnusualError

_UNSIGNED_SIZES = {0xCC: 1, 0xCD: 2, 0xCE: 4, 0xCF: 8}
_SIGNED_SIZES = {0xD0: 1, 0xD1: 2, 0xD2: 4, 0xD3: 8}
_TEXT_SIZES = {0xD9: 1, 0xDA: 2, 0xDB: 4}
#: MessagePack's tag of an unsigned integer of 32 bits
UINT32 = b"\xce"
#: what is before the two integers of a `builtin_interfaces/Time`
TIME_KEYS = b"\x82\xa3sec", b"\xa7nanosec"
_FEW_TEXTS = 12
_USUAL_TEXT = 64  #: most texts have fewer bytes
#: Settings of a msgpack that refuses all values that could need much memory.
_ONLY_TEXTS = {"max_array_len": 0, "max_map_len": 0, "max_bin_len": 0, "max_ext_len": 0}
#: size in bytes from which a view saves time, because the numbers are then copied only once
_LARGE = 1 << 12


def read_integer(data: bytes, position: int) -> tuple[int, int]:
    """Read an integer of any size."""
    tag = data[position]
    begin = position + 1
    if tag < 0x80:
        return tag, begin
    if tag >= 0xE0:
        return tag - 0x100, begin
    is_signed = tag in _SIGNED_SIZES
    end = begin + (_SIGNED_SIZES if is_signed else _UNSIGNED_SIZES)[tag]
    return int.from_bytes(data[begin:end], "big", signed=is_signed), end


def read_time(data: bytes, position: int) -> tuple[int, int, int]:
    """Read a `builtin_interfaces/Time`: its seconds and its nanoseconds."""
    if not data.startswith(TIME_KEYS[0], position):
        raise UnusualError
    seconds, position = read_integer(data, position + len(TIME_KEYS[0]))
    if not data.startswith(TIME_KEYS[1], position) or not -(2**31) <= seconds < 2**31:
        raise UnusualError
    nanoseconds, position = read_integer(data, position + len(TIME_KEYS[1]))
    if not 0 <= nanoseconds < 2**32:
        raise UnusualError
    return seconds, nanoseconds, position


def read_text(data: bytes, position: int) -> tuple[str, int]:
    """Read a text."""
    tag = data[position]
    if 0xA0 <= tag < 0xC0:
        size, begin = tag - 0xA0, position + 1
    else:
        size, begin = _size(data, position + 1, _TEXT_SIZES[tag])
    end = begin + size
    return data[begin:end].decode(), end


def read_texts(data: bytes, position: int, count: int) -> tuple[list[str], int]:
    """Read as many texts as an array has."""
    if count > _FEW_TEXTS:
        return _read_many_texts(data, position, count)
    texts: list[str] = []
    for _ in range(count):
        tag = data[position]
        if 0xA0 <= tag < 0xC0:  # a call of `read_text` would take longer
            end = position + tag - 0xA0 + 1
            texts.append(data[position + 1 : end].decode())
        else:
            text, end = read_text(data, position)
            texts.append(text)
        position = end
    return texts, position


def _read_many_texts(data: bytes, position: int, count: int) -> tuple[list[str], int]:
    """Read texts with msgpack, which begins slower than `read_texts` but needs less for each."""
    # Usually a part of the bytes contains all texts. msgpack copies the bytes that it gets, so each
    # larger part has four times the length. The rest of a long message would be copied often.
    size = _USUAL_TEXT * count
    while True:
        part = data[position : position + size]
        unpacker = msgpack.Unpacker(max_buffer_size=len(part), **_ONLY_TEXTS)
        unpacker.feed(part)
        texts = list(islice(unpacker, count))
        if len(texts) == count or len(part) < size:  # or this was the rest of the bytes
            break
        size *= 4
    if len(texts) != count or set(map(type, texts)) != {str}:
        raise UnusualError
    return texts, position + unpacker.tell()


def read_bools(data: bytes, position: int, count: int) -> tuple[list[bool], int]:
    """Read as many bools as an array has."""
    end = position + count
    tags = data[position:end]
    if len(tags) != count or tags.strip(b"\xc2\xc3"):
        raise UnusualError
    return [tag == 0xC3 for tag in tags], end


def read_count(data: bytes, position: int) -> tuple[int, int]:
    """Read the header of an array of messages or texts, and return the number of its items."""
    tag = data[position]
    if 0x90 <= tag < 0xA0:
        return tag - 0x90, position + 1
    return _size(data, position + 1, {0xDC: 2, 0xDD: 4}[tag])


def read_numbers(data: bytes, position: int, typecode: str, code: int) -> tuple[array[Any], int]:
    """Read a numeric array on a machine whose order of bytes is little-endian.

    Args:
        data: All bytes of the message.
        position: Where the array begins.
        typecode: The typecode of the result.
        code: The code of the extension, or 0 if the array is a binary.
    """
    tag, begin = data[position], position + 1
    if tag in {0xC4, 0xC7}:
        size, begin = data[begin], begin + 1
    elif tag in {0xC5, 0xC8}:
        size, begin = data[begin] << 8 | data[begin + 1], begin + 2
    elif tag in {0xC6, 0xC9}:
        size, begin = _size(data, begin, 4)
    elif 0xD4 <= tag <= 0xD8:
        size = 1 << tag - 0xD4
    else:
        raise UnusualError
    if code:
        begin += 1
    end = begin + size
    # Tags up to 0xC6 are those of binaries.
    if end > len(data) or (tag > 0xC6) != (code > 0) or (code and data[begin - 1] != code):
        raise UnusualError
    if size < _LARGE:
        return array(typecode, data[begin:end]), end
    values: array[Any] = array(typecode)
    values.frombytes(memoryview(data)[begin:end])
    return values, end


def read_octets(data: bytes, position: int) -> tuple[list[bytes], int]:
    """Read an array of `byte`, which is sent as a binary."""
    numbers, end = read_numbers(data, position, "B", 0)
    return [bytes((number,)) for number in numbers], end


def array_header(count: int) -> bytes:
    """Return the header of an array with `count` items."""
    if count < 16:
        return bytes((0x90 | count,))
    if count < 1 << 16:
        return b"\xdc" + count.to_bytes(2, "big")
    return b"\xdd" + count.to_bytes(4, "big")


def _size(data: bytes, begin: int, width: int) -> tuple[int, int]:
    """Return a size that is written in `width` bytes, and the position after these bytes."""
    end = begin + width
    return int.from_bytes(data[begin:end], "big"), end
