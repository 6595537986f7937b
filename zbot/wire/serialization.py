"""Messages as bytes in ROS 2's own format, CDR, e.g. for files that other programs read."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar, cast

from zbot.wire.payload import is_cdr

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["deserialize_message", "is_cdr", "raw_decoder", "serialize_message"]

MsgT = TypeVar("MsgT")


def serialize_message(message: Any) -> bytes:
    """Return a message's CDR: a header of 4 bytes, then its fields in little-endian.

    Raises:
        NotAMessageTypeError: It is no message.
        CodecError: A field has a wrong value.
    """
    from zbot.wire.cdr import cdr_codec_for  # noqa: PLC0415 - few programs need it

    return cdr_codec_for(type(message)).encode(message)


def deserialize_message(serialized_message: bytes, message_type: type[MsgT]) -> MsgT:
    """Return the message that CDR stands for; bytes after it are ignored.

    Raises:
        NotAMessageTypeError: The class is no message's.
        CodecError: The bytes are no message of the type.
    """
    from zbot.wire.cdr import cdr_codec_for  # noqa: PLC0415 - as above

    return cast("MsgT", cdr_codec_for(message_type).decode(bytes(serialized_message)))


def raw_decoder(decode: Callable[[Any], Any]) -> Callable[[Any], bytes]:
    """Return what turns a payload into CDR, given what turns it into a message."""
    return lambda payload: serialize_message(decode(payload))
