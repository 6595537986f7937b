"""Serialization of messages as CDR, ROS 2's format, e.g. for files that other programs read."""

from __future__ import annotations

from typing import Any, TypeVar

from zbot.wire.payload import is_cdr

__all__ = ["deserialize_message", "is_cdr", "serialize_message"]

MsgT = TypeVar("MsgT")


def serialize_message(message: Any) -> bytes:
    """Return a message as CDR: a header of 4 bytes, then the fields in little-endian.

    Raises:
        NotAMessageTypeError: The object is not a message.
        CodecError: A field has a wrong value.
    """
    from zbot.wire.cdr import cdr_codec_for  # noqa: PLC0415 - few programs need it

    return cdr_codec_for(type(message)).encode(message)


def deserialize_message(serialized_message: bytes, message_type: type[MsgT]) -> MsgT:
    """Return the message that CDR bytes contain. Additional bytes after the message are ignored.

    Raises:
        NotAMessageTypeError: The class is not a message class.
        CodecError: The bytes are not a message of the type.
    """
    from zbot.wire.cdr import cdr_codec_for  # noqa: PLC0415 - few programs need it

    return cdr_codec_for(message_type).decode(bytes(serialized_message))
