"""Serialization of messages as CDR, ROS 2's format, e.g. for files that other programs read."""

from __future__ import annotations

import warnings
from typing import Any, TypeVar

from zbot.wire.errors import CodecError
from zbot.wire.payload import is_cdr

__all__ = ["deserialize_message", "is_cdr", "serialize_message"]

MsgT = TypeVar("MsgT")

_warned: set[str] = set()  # types whose warning was given


def serialize_message(message: Any) -> bytes:
    """Return a message as CDR: a header of 4 bytes, then the fields in little-endian.

    Raises:
        NotAMessageTypeError: The object is not a message.
        CodecError: A field has a wrong value.
    """
    from zbot.wire.cdr.codec import cdr_codec_for  # noqa: PLC0415 - few programs need it

    return cdr_codec_for(type(message)).encode(message)


def deserialize_message(serialized_message: bytes, message_type: type[MsgT]) -> MsgT:
    """Return the message that CDR bytes contain. Additional bytes after the message are ignored.

    Bytes of a text that are not UTF-8 become U+FFFD, and a bool of 2 is true. For each type, the
    first such message causes a warning.

    Raises:
        NotAMessageTypeError: The class is not a message class.
        CodecError: The bytes are not a message of the type.
    """
    from zbot.wire.cdr.codec import cdr_codec_for  # noqa: PLC0415 - few programs need it

    codec, data = cdr_codec_for(message_type), bytes(serialized_message)
    try:
        return codec.decode_strictly(data)
    except CodecError as error:
        message = codec.decode(data)
        if codec.type_name not in _warned:
            _warned.add(codec.type_name)
            warnings.warn(error.replacement(), stacklevel=2)
        return message
