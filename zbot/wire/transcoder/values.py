"""Conversions of single values for the generated transcoders."""

from __future__ import annotations

from typing import Any

import msgpack  # type: ignore[import-untyped]

from zbot.wire.validation import Fault

# The codecs convert messages with longer lists, because they validate the bytes first.
_SHORT_LIST = 1024
_ExtType = msgpack.ExtType

BOOL = {True: True, False: False}


def unpack_raw(data: bytes) -> Any:
    """Return the value in MessagePack. A numeric array is a tuple of its code and its bytes."""
    return msgpack.unpackb(
        data, ext_hook=_raw_extension, strict_map_key=True, max_array_len=_SHORT_LIST
    )


def _raw_extension(code: int, data: bytes) -> tuple[int, bytes]:
    return code, data


def extension_of(code: int, data: bytes) -> Any:
    """Return the bytes of a numeric array as an extension for `pack`."""
    return tuple.__new__(_ExtType, (code, data))


def number_bytes(field: str, value: Any, code: int, size: int) -> bytes:
    """Return the bytes of a numeric array whose items have `size` bytes."""
    if value.__class__ is tuple and value[0] == code and not len(value[1]) % size:
        data: bytes = value[1]
        return data
    return plain_bytes(field, value)


def plain_bytes(field: str, value: Any) -> bytes:
    """Return the value if it is `bytes`. Otherwise raise `Fault`."""
    if value.__class__ is bytes:
        data: bytes = value
        return data
    raise Fault(field, "it is not in the usual form")
