"""Serialization of messages as CDR, ROS 2's format, e.g. for files that other programs read."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.wire.payload import is_cdr

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["deserialize_message", "is_cdr", "raw_decoder", "serialize_message"]

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

    return cast("MsgT", cdr_codec_for(message_type).decode(bytes(serialized_message)))


def raw_decoder(decode: Callable[[Any], Any]) -> Callable[[Any], bytes]:
    """Return a function that converts payloads to CDR. `decode` is the decoder of the payloads."""
    return lambda payload: serialize_message(decode(payload))
