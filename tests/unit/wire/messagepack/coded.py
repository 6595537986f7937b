"""Functions that encode and decode messages."""

from __future__ import annotations

from typing import Any

import msgpack  # type: ignore[import-untyped]

from zbot.wire.messagepack.codec import messagepack_codec_for

packb: Any = msgpack.packb


def encode(value: Any) -> bytes:
    return messagepack_codec_for(type(value)).encode(value)


def decode(message_class: Any, value: Any) -> Any:
    data = value if isinstance(value, (bytes, bytearray, memoryview)) else packb(value)
    return messagepack_codec_for(message_class).decode_strictly(data)
